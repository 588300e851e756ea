// Plays a recorded drive to lifecycle nodes, and records what they send:
//
//     player MODE TRACE RECORDED END_NS [PROCESS@FUNCTION@TIME_NS...]
//     player MODE - RECORDED
//
// TRACE is a normalized trace, as `sigcat normalize` writes it. MODE is `lock` (step by step, as fast as possible) or `free` (in real time): nodes are brought through their life. A gateway
// writes the rows of `-` to standard input while they are sent; it has two more modes, for nodes that run already: `timed`, rows
// are sent at their times, and `live`, as they come. RECORDED then also says which columns no node receives (`unknown NAME`),
// when everybody listens (`ready`), and at the end how many values were sent (`sent COUNT`), in real time also how many of them while a
// node was gone (`unheard COUNT`). At the time of a kill it asks for it on standard output, and continues when it is answered.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "lifecycle_msgs/msg/transition.hpp"
#include "player/ports.h"
#include "player/steps.h"
#include "player/trace.h"
#include "rclcpp/rclcpp.hpp"

namespace {

using Transition = lifecycle_msgs::msg::Transition;

using player::kNever;

constexpr std::chrono::milliseconds kRest{300};  // what the last row leads to is recorded, too

struct Kill final {
    std::string process;
    std::size_t node;
    std::uint64_t time;
};

/// When each call is due next.
std::uint64_t NextRelease(std::uint64_t from) {
    std::uint64_t next = kNever;
    for (const auto& [period, offset] : player::Cycles()) {
        next = std::min(next, from <= offset ? offset : offset + (from - offset + period - 1) / period * period);
    }
    return next;
}

/// Rows of a trace that was read before.
class ReadRows final {
public:
    ReadRows(player::Trace trace, std::uint64_t end) : trace_{std::move(trace)}, end_{end} {}

    const std::vector<std::string>& Columns() const { return trace_.columns; }
    std::uint64_t Time() const { return index_ < trace_.rows.size() ? trace_.rows[index_].time : kNever; }
    std::uint64_t End() const { return end_; }
    const player::Row& Row() const { return trace_.rows[index_]; }
    void Advance() { ++index_; }

private:
    player::Trace trace_;
    std::uint64_t end_;
    std::size_t index_{0};
};

template <typename RowsT>
class Play final {
public:
    Play(RowsT& rows, player::Ports& ports, player::Steps& steps, player::Record& record, std::vector<Kill> kills)
        : rows_{rows}, ports_{ports}, steps_{steps}, record_{record}, kills_{std::move(kills)} {}

    std::uint64_t Count() const { return count_; }

    /// The clock of the nodes is at 0 when the drive is at `begin`.
    void InLockStep(std::uint64_t begin) {
        begin_ = begin;
        for (std::uint64_t time = Next(begin); time <= rows_.End();) {
            record_.SetNow(time - begin);
            KillUntil(time);
            SendUntil(time, true, static_cast<std::int64_t>(time - begin));
            const bool is_due = NextRun(time - begin) == time - begin || player::HasEvents();
            while (is_due && (steps_.Step(time - begin) || IsWantedAgain(time))) {
            }
            const std::uint64_t next = Next(time + 1);  // reads on: afterwards the end may be known
            const std::uint64_t after = std::min(next, rows_.End());
            steps_.Advance(after - begin);
            if (after == time) {
                break;
            }
            time = after;
        }
    }

    /// Of a row, the time since the begin of the drive, at which the clock of the nodes was at `epoch`, is its stamp.
    void InRealTime(std::int64_t epoch, bool is_live) {
        const auto start = std::chrono::steady_clock::now();
        for (std::uint64_t time = rows_.Time(); time != kNever && time <= rows_.End(); time = rows_.Time()) {
            if (!is_live) {
                std::this_thread::sleep_until(start + std::chrono::nanoseconds{static_cast<std::int64_t>(time)});
            }
            KillUntil(time);
            const std::uint64_t before = count_;
            SendUntil(time, false, epoch + static_cast<std::int64_t>(time));
            unheard_ += ports_.AreConnected() ? 0 : count_ - before;
            record_.TellSent(time);
        }
        if (rows_.End() != kNever) {
            std::this_thread::sleep_until(start + std::chrono::nanoseconds{static_cast<std::int64_t>(rows_.End())});
        }
        record_.Say("unheard " + std::to_string(unheard_));
    }

private:
    /// Whether a node has more to do at this time, once: it waits for what it has sent to be taken.
    bool IsWantedAgain(std::uint64_t time) {
        const bool is_wanted = asked_again_ != time && steps_.AreTold() && steps_.NextFrom(time - begin_) == time - begin_;
        asked_again_ = is_wanted ? time : asked_again_;
        return is_wanted;
    }

    /// When a node runs next: it says so, unless a person wrote it.
    std::uint64_t NextRun(std::uint64_t from) const {
        return steps_.AreTold() ? steps_.NextFrom(from) : NextRelease(from);
    }

    std::uint64_t Next(std::uint64_t from) const {
        const std::uint64_t run = NextRun(from - begin_);
        std::uint64_t next = std::min(rows_.Time(), run == kNever ? kNever : begin_ + run);
        for (const auto& kill : kills_) {
            next = kill.time >= from ? std::min(next, kill.time) : next;
        }
        return next;
    }

    /// Values of one time and message are sent as one; repeated values are sent twice.
    void SendUntil(std::uint64_t time, bool is_lock_step, std::int64_t stamp) {
        ports_.Forget();
        for (; rows_.Time() <= time; rows_.Advance()) {
            const auto set = [this](const auto& name, const auto& cell) { return ports_.Set(name, cell); };
            count_ += player::SendCells(rows_.Columns(), rows_.Row(), set);
            if (is_lock_step && ports_.Repeats()) {
                steps_.Wait();
                ports_.Forget();
            }
            ports_.Publish(stamp);
        }
    }

    void KillUntil(std::uint64_t time) {
        for (auto& kill : kills_) {
            if (kill.time <= time && !kill.process.empty()) {
                std::string done;
                std::cout << "kill " << kill.process << std::endl;
                std::getline(std::cin, done);
                steps_.Forget(kill.node);
                kill.process.clear();
            }
        }
    }

    RowsT& rows_;
    player::Ports& ports_;
    player::Steps& steps_;
    player::Record& record_;
    std::vector<Kill> kills_;
    std::uint64_t begin_{0};
    std::uint64_t asked_again_{kNever};
    std::uint64_t count_{0};
    std::uint64_t unheard_{0};
};

Kill KillOf(const std::string& text) {
    const auto first = text.find('@');
    const auto second = text.find('@', first + 1);
    const auto node = player::Functions().at(text.substr(first + 1, second - first - 1));
    return {text.substr(0, first), node, std::stoull(text.substr(second + 1))};
}

/// `begin` is when the nodes were asked for: their discovery of each other is not reported, and on a busy machine it takes longer.
void AwaitConnections(const player::Ports& ports, std::chrono::steady_clock::time_point begin) {
    const auto end = std::chrono::steady_clock::now() + player::kPatience;
    while (!ports.AreConnected()) {
        if (std::chrono::steady_clock::now() > end) {
            throw std::runtime_error{"Not every subscription has been found."};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
    std::this_thread::sleep_for(std::chrono::seconds{1} + (std::chrono::steady_clock::now() - begin));
}

/// A node, spun by a thread meanwhile.
class Spinning final {
public:
    explicit Spinning(const std::shared_ptr<rclcpp::Node>& node) { executor_.add_node(node); }
    ~Spinning() {
        executor_.cancel();
        thread_.join();
    }
    Spinning(const Spinning&) = delete;
    Spinning& operator=(const Spinning&) = delete;

private:
    rclcpp::executors::SingleThreadedExecutor executor_;
    std::thread thread_{[this] { executor_.spin(); }};
};

void TellUnknown(const player::Ports& ports, const std::vector<std::string>& columns, player::Record& record) {
    for (const auto& name : columns) {
        if (!ports.Has(name)) {
            record.Say("unknown " + name);
        }
    }
}

/// When the drive is at its first row; 0 without any. Waits for one.
template <typename RowsT>
std::uint64_t BeginOf(RowsT& rows) {
    const std::uint64_t begin = rows.Time();
    return begin == kNever ? 0 : begin;
}

/// How many values were sent. `begin` is what is known of the first row's time before anything is played.
template <typename RowsT>
std::uint64_t Run(const std::shared_ptr<rclcpp::Node>& node, const std::string& mode, RowsT& rows, player::Record& record,
                  std::vector<Kill> kills, std::uint64_t begin) {
    const bool is_lock_step = mode == "lock";
    const bool has_life = is_lock_step || mode == "free";
    const Spinning spinning{node};
    const std::int64_t never = std::numeric_limits<std::int64_t>::max();
    record.Begin(is_lock_step ? 0 : never, begin);  // what was sent before counts as of the begin
    player::Ports ports{*node, record, is_lock_step};
    player::Connect(ports);
    player::Steps steps{*node, record};
    const auto asked = std::chrono::steady_clock::now();
    if (has_life) {
        steps.Change(Transition::TRANSITION_CONFIGURE);
    }
    AwaitConnections(ports, asked);
    const std::int64_t epoch = is_lock_step ? 0 : node->now().nanoseconds();
    record.Begin(epoch, begin);
    if (has_life) {
        steps.Change(Transition::TRANSITION_ACTIVATE);
    }
    TellUnknown(ports, rows.Columns(), record);
    record.Say("ready");
    Play<RowsT> play{rows, ports, steps, record, std::move(kills)};
    if (is_lock_step) {
        const std::uint64_t first = BeginOf(rows);
        record.Begin(epoch, first);
        play.InLockStep(first);
    } else {
        play.InRealTime(epoch, mode == "live");
    }
    if (has_life) {
        steps.Change(Transition::TRANSITION_DEACTIVATE);
        steps.Change(Transition::TRANSITION_CLEANUP);
    } else {
        std::this_thread::sleep_for(kRest);
    }
    return play.Count();
}

void Run(const std::shared_ptr<rclcpp::Node>& node, int count, char** arguments) {
    const bool is_read = std::string{arguments[2]} == "-";
    player::Record record{arguments[3], player::Nodes().size(), is_read};
    if (is_read) {
        player::RowStream rows{std::cin};
        const std::uint64_t sent = Run(node, arguments[1], rows, record, {}, 0);
        record.Say("sent " + std::to_string(sent));
        return;
    }
    std::vector<Kill> kills;
    for (int i = 5; i < count; ++i) {
        kills.push_back(KillOf(arguments[i]));
    }
    ReadRows rows{player::ReadTrace(arguments[2]), std::stoull(arguments[4])};
    const bool is_lock_step = std::string{arguments[1]} == "lock";
    if (!is_lock_step) {
        record.TimeIn(std::string{arguments[3]} + ".times");
    }
    const std::uint64_t begin = is_lock_step ? BeginOf(rows) : 0;
    static_cast<void>(Run(node, arguments[1], rows, record, std::move(kills), begin));
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 4 || (count == 4 && std::string{arguments[2]} != "-")) {
        std::fprintf(stderr, "player MODE TRACE RECORDED END_NS [PROCESS@FUNCTION@TIME_NS...]\n"
                             "player MODE - RECORDED\n");
        return EXIT_FAILURE;
    }
    rclcpp::init(0, nullptr);
    int status = EXIT_SUCCESS;
    std::shared_ptr<rclcpp::Node> node;
    try {
        node = std::make_shared<rclcpp::Node>("player");
        Run(node, count, arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "player: %s\n", error.what());
        status = EXIT_FAILURE;
    }
    rclcpp::shutdown();
    // The node is left as it is: Fast DDS 2.14 may wait for itself for ever if it is taken apart while others leave.
    std::fflush(nullptr);
    std::_Exit(status);
}
