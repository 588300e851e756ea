// Plays a recorded drive over the network, and records what the components send:
//
//     player TRACE RECORDED [SECONDS]
//
// In real time, or with BENCH_PLAYER in lock-step: that is the port at which it waits for the components.
// The trace is repeated until SECONDS are over; without them it is played once.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>

#include "ara/core/initialization.h"
#include "player/lock_step.h"
#include "player/ports.h"
#include "player/trace.h"

namespace {

constexpr std::uint64_t kPause = 100000000;  // ns between the end of a drive and its repetition

void SendRow(player::Ports& ports, const player::Trace& trace, const player::Row& row) {
    for (std::size_t i = 0; i < trace.columns.size() && i < row.cells.size(); ++i) {
        if (!row.cells[i].empty()) {
            static_cast<void>(ports.Send(trace.columns[i], row.cells[i]));
        }
    }
}

/// The rows of a trace, again and again.
class Rows final {
public:
    explicit Rows(const player::Trace& trace) : trace_(trace) {}

    std::uint64_t Time() const { return offset_ + trace_.rows[index_].time; }
    const player::Row& Row() const { return trace_.rows[index_]; }

    void Advance() {
        if (++index_ == trace_.rows.size()) {
            offset_ += trace_.rows.back().time - trace_.rows.front().time + kPause;
            index_ = 0;
        }
    }

private:
    const player::Trace& trace_;
    std::size_t index_{0};
    std::uint64_t offset_{0};
};

void PlayInLockStep(const player::Trace& trace, std::uint16_t port, std::uint64_t end, player::Recorder& recorder) {
    player::Ports ports{recorder};
    player::LockStep steps{port, player::Ports::Components()};
    Rows rows{trace};
    SendRow(ports, trace, rows.Row());  // fields have a value before they are offered
    ports.Offer();
    ports.Find();
    std::uint64_t time = rows.Time();
    steps.Tell(time);
    steps.AwaitConnections();
    steps.AwaitRest();
    recorder.Begin(time);
    while (time <= end) {
        recorder.SetTime(time);
        steps.Tell(time);
        for (; rows.Time() <= time; rows.Advance()) {
            SendRow(ports, trace, rows.Row());
        }
        steps.AwaitRest();
        steps.Run();
        time = std::min(steps.NextAfter(time), rows.Time());
    }
    ports.Leave();
}

void PlayInRealTime(const player::Trace& trace, std::uint64_t end, player::Recorder& recorder) {
    player::Ports ports{recorder};
    Rows rows{trace};
    SendRow(ports, trace, rows.Row());
    ports.Offer();
    ports.Find();
    const auto start = std::chrono::steady_clock::now();
    recorder.Begin(0);
    for (; rows.Time() <= end; rows.Advance()) {
        std::this_thread::sleep_until(start + std::chrono::nanoseconds{static_cast<std::int64_t>(rows.Time())});
        recorder.SetTime(rows.Time());
        SendRow(ports, trace, rows.Row());
    }
    ports.Leave();
}

int Play(const std::string& file, const std::string& recorded, double seconds) {
    try {
        const player::Trace trace = player::ReadTrace(file);
        player::Recorder recorder{recorded};
        const std::uint64_t last = trace.rows.back().time;
        const std::uint64_t end = seconds > 0 ? static_cast<std::uint64_t>(seconds * 1e9) : last;
        const char* const port = std::getenv("BENCH_PLAYER");
        if (port != nullptr) {
            PlayInLockStep(trace, static_cast<std::uint16_t>(std::atoi(port)), end, recorder);
        } else {
            PlayInRealTime(trace, end, recorder);
        }
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "player: %s\n", error.what());
        return EXIT_FAILURE;
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 3) {
        std::fprintf(stderr, "player TRACE RECORDED [SECONDS]\n");
        return EXIT_FAILURE;
    }
    if (!ara::core::Initialize().HasValue()) {
        std::fprintf(stderr, "player: the address cannot be used\n");
        return EXIT_FAILURE;
    }
    const int status = Play(arguments[1], arguments[2], count > 3 ? std::atof(arguments[3]) : 0.0);
    return ara::core::Deinitialize().HasValue() ? status : EXIT_FAILURE;
}
