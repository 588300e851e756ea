// Times of one clock of the machine, which all processes share.
#ifndef BENCH_PROGRAMS_TIMES_H_
#define BENCH_PROGRAMS_TIMES_H_

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPeriod{1};

inline std::int64_t Now() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
}

// Begins when the receiver, whose output is the input, says so; calls `send` each millisecond, and gives when it did.
template <typename Send>
std::vector<std::int64_t> Pace(std::size_t count, Send send) {
    std::vector<std::int64_t> times;
    times.reserve(count);
    std::string line;
    if (!std::getline(std::cin, line)) {
        return times;
    }
    auto next = Clock::now();
    while (times.size() < count) {
        next += kPeriod;
        std::this_thread::sleep_until(next);
        times.push_back(Now());
        send(static_cast<float>(times.size()));
    }
    return times;
}

// Until the receiver has ended.
inline void AwaitReceiver() {
    for (std::string line; std::getline(std::cin, line);) {
    }
}

inline void Write(const char* path, const std::vector<std::int64_t>& times) {
    std::ofstream file{path};
    for (const auto time : times) {
        file << time << '\n';
    }
}

#endif  // BENCH_PROGRAMS_TIMES_H_
