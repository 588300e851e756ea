// Plays a recorded drive over the network, and records what the components send:
//
//     player [--speed FACTOR] TRACE RECORDED [SECONDS [PROCESS@COMPONENT@TIME_NS...]]
//     player - RECORDED [live]
//
// TRACE is a normalized trace, as `sigcat normalize` writes it.
// A gateway writes the rows of `-` to standard input while they are sent: at their times, or as they come, if they are `live`.
// Then RECORDED also says which columns no component receives (`unknown NAME`), when everybody listens (`ready`), and at the end how
// many values were sent (`sent COUNT`), and how many of them while a process was gone (`unheard COUNT`).
// In real time, or with BENCH_PLAYER in lock-step: that is the port at which it waits for the components.
// --speed, or BENCH_SPEED, plays it so many times faster in real time; components need the same BENCH_SPEED. At a terminal, the
// player shows how much was played.
// The trace is repeated until SECONDS are over; without them it is played once. In lock-step, processes may be killed on the
// way: when it is time, it asks for that on standard output (`kill PROCESS`), and continues when it is answered.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ara/core/initialization.h"
#include "bench/counters.h"
#include "player/lock_step.h"
#include "player/ports.h"
#include "player/progress.h"
#include "player/speed.h"
#include "player/trace.h"

namespace {

constexpr std::chrono::seconds kPatience{20};
constexpr std::chrono::milliseconds kRest{300};  // what the last row leads to is recorded, too
constexpr std::uint64_t kPause = 100000000;  // ns between the end of a drive and its repetition

/// How many values of it were sent.
std::uint64_t SendRow(player::Ports& ports, const std::vector<std::string>& columns, const player::Row& row) {
    return player::SendCells(columns, row, [&ports](const auto& name, const auto& cell) { return ports.Send(name, cell); });
}

void TellUnknown(const player::Ports& ports, const std::vector<std::string>& columns, player::Recorder& recorder) {
    for (const auto& name : columns) {
        if (!ports.Has(name)) {
            recorder.Say("unknown " + name);
        }
    }
}

/// The rows of a trace, again and again until the drive ends.
class RepeatedRows final {
public:
    RepeatedRows(const player::Trace& trace, std::uint64_t end) : trace_(trace), end_{end} {}

    const std::vector<std::string>& Columns() const { return trace_.columns; }
    std::uint64_t Time() const { return offset_ + trace_.rows[index_].time; }
    std::uint64_t End() const { return end_; }
    const player::Row& Row() const { return trace_.rows[index_]; }

    void Advance() {
        if (++index_ == trace_.rows.size()) {
            offset_ += trace_.rows.back().time - trace_.rows.front().time + kPause;
            index_ = 0;
        }
    }

private:
    const player::Trace& trace_;
    std::uint64_t end_;
    std::size_t index_{0};
    std::uint64_t offset_{0};
};

/// A process that is killed on the way.
struct Kill final {
    std::string process;
    std::string component;
    std::uint64_t time;
};

class Kills final {
public:
    explicit Kills(std::vector<Kill> kills) : kills_(std::move(kills)) {
        std::sort(kills_.begin(), kills_.end(), [](const Kill& a, const Kill& b) { return a.time < b.time; });
    }

    std::uint64_t Time() const { return kills_.empty() ? std::numeric_limits<std::uint64_t>::max() : kills_[0].time; }

    void Until(std::uint64_t time, player::LockStep& steps) {
        while (Time() <= time) {
            std::string done;
            std::cout << "kill " << kills_[0].process << std::endl;
            std::getline(std::cin, done);
            steps.Forget(kills_[0].component);
            kills_.erase(kills_.begin());
        }
    }

private:
    std::vector<Kill> kills_;
};

Kill KillOf(const std::string& text) {
    const auto first = text.find('@');
    const auto second = text.find('@', first + 1);
    return {text.substr(0, first), text.substr(first + 1, second - first - 1), std::stoull(text.substr(second + 1))};
}

template <typename RowsT>
std::uint64_t PlayInLockStep(RowsT& rows, std::uint16_t port, Kills kills, player::Recorder& recorder) {
    player::Ports ports{recorder};
    player::LockStep steps{port, player::Ports::Components()};
    std::uint64_t count = 0;
    std::uint64_t time = rows.Time();
    if (time == player::kNever) {
        return 0;
    }
    SendRow(ports, rows.Columns(), rows.Row());  // fields have a value before they are offered
    ports.Offer();
    ports.Find();
    steps.Tell(time);
    steps.AwaitConnections();
    steps.AwaitRest();
    TellUnknown(ports, rows.Columns(), recorder);
    recorder.Say("ready");
    recorder.Begin(time);
    player::ProgressLine progress{rows.End()};
    while (time <= rows.End()) {
        progress.Reach(time);
        recorder.SetTime(time);
        kills.Until(time, steps);
        steps.Tell(time);
        for (; rows.Time() <= time; rows.Advance()) {
            count += SendRow(ports, rows.Columns(), rows.Row());
        }
        steps.AwaitRest();
        steps.Run();
        time = std::min({steps.NextAfter(time), rows.Time(), kills.Time()});
    }
    ports.Leave();
    return count;
}

void PlayInRealTime(const player::Trace& trace, std::uint64_t end, double speed, player::Recorder& recorder) {
    player::Ports ports{recorder};
    RepeatedRows rows{trace, end};
    SendRow(ports, trace.columns, rows.Row());
    ports.Offer();
    ports.Find();
    const auto start = std::chrono::steady_clock::now();
    recorder.BeginNow(speed);
    player::ProgressLine progress{end};
    for (; rows.Time() <= end; rows.Advance()) {
        std::this_thread::sleep_until(start + player::OnTheClock(rows.Time(), speed));
        SendRow(ports, trace.columns, rows.Row());
        recorder.TellSent(rows.Time());
        progress.Reach(rows.Time());
    }
    std::this_thread::sleep_until(start + player::OnTheClock(end, speed));
    progress.Reach(end);
    ports.Leave();
}

bool IsEverybodyThere(const player::Ports& ports) { return bench::Count().missing == 0 && ports.AreHeard(); }

void AwaitConnections(const player::Ports& ports) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!IsEverybodyThere(ports)) {
        if (std::chrono::steady_clock::now() > end) {
            throw std::runtime_error{"Not every component runs that these values are for."};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{200});  // a process subscribes to one group after the other
}

/// Rows are sent at their times, or, if they are `live`, when they come: once everybody listens.
std::uint64_t PlayStream(player::RowStream& rows, bool is_live, player::Recorder& recorder) {
    player::Ports ports{recorder};
    if (!is_live && rows.Time() != player::kNever) {
        SendRow(ports, rows.Columns(), rows.Row());  // fields have a value before they are offered
    }
    ports.Offer();
    ports.Find();
    AwaitConnections(ports);
    TellUnknown(ports, rows.Columns(), recorder);
    recorder.Say("ready");
    recorder.BeginNow();
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t count = 0;
    std::uint64_t unheard = 0;
    for (; rows.Time() != player::kNever; rows.Advance()) {
        if (!is_live) {
            std::this_thread::sleep_until(start + std::chrono::nanoseconds{static_cast<std::int64_t>(rows.Time())});
        }
        const std::uint64_t sent = SendRow(ports, rows.Columns(), rows.Row());
        count += sent;
        unheard += IsEverybodyThere(ports) ? 0 : sent;
    }
    std::this_thread::sleep_for(kRest);
    recorder.Say("unheard " + std::to_string(unheard));
    ports.Leave();
    return count;
}

int Play(const std::string& file, const std::string& recorded, double seconds, const char* speed, Kills kills) {
    try {
        const double factor = speed != nullptr ? player::Speed(speed) : player::Speed();
        const player::Trace trace = player::ReadTrace(file);
        player::Recorder recorder{recorded, false};
        if (trace.rows.empty()) {
            throw std::runtime_error{file + " must have a row of values after its header"};
        }
        const std::uint64_t last = trace.rows.back().time;
        const std::uint64_t end = seconds > 0 ? static_cast<std::uint64_t>(seconds * 1e9) : last;
        const char* const port = std::getenv("BENCH_PLAYER");
        if (port != nullptr) {
            RepeatedRows rows{trace, end};
            PlayInLockStep(rows, static_cast<std::uint16_t>(std::atoi(port)), std::move(kills), recorder);
        } else {
            recorder.TimeIn(recorded + ".times");
            PlayInRealTime(trace, end, factor, recorder);
        }
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "player: %s\n", error.what());
        return EXIT_FAILURE;
    }
}

int PlayInput(const std::string& recorded, bool is_live) {
    try {
        player::Recorder recorder{recorded, true};
        player::RowStream rows{std::cin};
        const char* const port = std::getenv("BENCH_PLAYER");
        const std::uint64_t count = port == nullptr
            ? PlayStream(rows, is_live, recorder)
            : PlayInLockStep(rows, static_cast<std::uint16_t>(std::atoi(port)), Kills{{}}, recorder);
        recorder.Say("sent " + std::to_string(count));
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "player: %s\n", error.what());
        return EXIT_FAILURE;
    }
}

}  // namespace

int main(int count, char** arguments) {
    const char* speed = nullptr;
    if (count > 2 && std::string{arguments[1]} == "--speed") {
        speed = arguments[2];
        count -= 2;
        arguments += 2;
    }
    if (count < 3) {
        std::fprintf(stderr, "player [--speed FACTOR] TRACE RECORDED [SECONDS [PROCESS@COMPONENT@TIME_NS...]]\n");
        return EXIT_FAILURE;
    }
    if (!ara::core::Initialize().HasValue()) {
        std::fprintf(stderr, "player: the address cannot be used\n");
        return EXIT_FAILURE;
    }
    if (std::string{arguments[1]} == "-") {
        const int status = PlayInput(arguments[2], count > 3 && std::string{arguments[3]} == "live");
        return ara::core::Deinitialize().HasValue() ? status : EXIT_FAILURE;
    }
    std::vector<Kill> kills;
    for (int i = 4; i < count; ++i) {
        kills.push_back(KillOf(arguments[i]));
    }
    const int status = Play(arguments[1], arguments[2], count > 3 ? std::atof(arguments[3]) : 0.0, speed, Kills{std::move(kills)});
    return ara::core::Deinitialize().HasValue() ? status : EXIT_FAILURE;
}
