#include "player/lock_step.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "bench/counters.h"

namespace player {

namespace {

constexpr int kAgain = 500;  // ms until a command that is not answered is sent again
constexpr int kTimes = 20;
constexpr int kQuiet = 4;
constexpr std::chrono::seconds kPatience{10};

using Steady = std::chrono::steady_clock;

}  // namespace

LockStep::LockStep(std::uint16_t port, const std::vector<std::string>& components) : socket_{port} {
    for (const auto& name : components) {
        peers_.push_back({name, 0, {}});
    }
    const auto end = Steady::now() + kPatience;
    while (std::any_of(peers_.begin(), peers_.end(), [](const Peer& peer) { return peer.port == 0; })) {
        std::string text;
        std::uint16_t from = 0;
        if (socket_.Receive(text, from, kAgain)) {
            for (auto& peer : peers_) {
                peer.port = text == "hello " + peer.name ? from : peer.port;
            }
        }
        if (Steady::now() > end) {
            throw std::runtime_error{"Not all components have said hello."};
        }
    }
}

void LockStep::Ask(Peer& peer, const std::string& what) {
    const std::uint64_t number = ++number_;
    const std::string command = std::to_string(number) + ' ' + what;
    for (int times = 0; times < kTimes; ++times) {
        socket_.Send(command, peer.port);
        std::string text;
        std::uint16_t from = 0;
        while (socket_.Receive(text, from, kAgain)) {
            std::istringstream words{text};
            std::uint64_t answered = 0;
            Progress progress;
            auto& counters = progress.counters;
            words >> answered >> counters.sent >> counters.received >> counters.running >> counters.missing >>
                progress.next;
            if (words && from == peer.port && answered == number) {
                peer.progress = progress;
                return;
            }
        }
    }
    throw std::runtime_error{peer.name + " does not answer."};
}

void LockStep::Tell(std::uint64_t time) {
    for (auto& peer : peers_) {
        Ask(peer, "time " + std::to_string(time));
    }
}

void LockStep::AwaitConnections() {
    const auto end = Steady::now() + kPatience;
    for (;;) {
        std::uint64_t missing = bench::Count().missing;
        for (auto& peer : peers_) {
            Ask(peer, "ask");
            missing += peer.progress.counters.missing;
        }
        if (missing == 0) {
            return;
        }
        if (Steady::now() > end) {
            throw std::runtime_error{std::to_string(missing) + " services or subscriptions are missing."};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
}

LockStep::Sums LockStep::Count() {
    const auto own = bench::Count();
    Sums sums{own.sent, own.received, own.running};
    for (auto& peer : peers_) {
        Ask(peer, "ask");
        sums.sent += peer.progress.counters.sent;
        sums.received += peer.progress.counters.received;
        sums.running += peer.progress.counters.running;
    }
    return sums;
}

void LockStep::Forget(const std::string& component) {
    peers_.erase(
        std::remove_if(peers_.begin(), peers_.end(), [&component](const Peer& peer) { return peer.name == component; }),
        peers_.end());
    is_complete_ = false;
}

// What is sent to a component that is gone is never received: then it is at rest if nothing more comes for a while.
bool LockStep::IsAtRest() {
    Sums sums = Count();
    if (is_complete_) {
        return sums.sent == sums.received && sums.running == 0;
    }
    for (int times = 0; times < kQuiet; ++times) {
        std::this_thread::sleep_for(std::chrono::milliseconds{2});
        const Sums now = Count();
        if (!(now == sums) || now.running != 0) {
            return false;
        }
    }
    return true;
}

void LockStep::AwaitRest() {
    const auto end = Steady::now() + kPatience;
    while (!IsAtRest()) {
        if (Steady::now() > end) {
            throw std::runtime_error{"An event was lost."};
        }
        std::this_thread::yield();
    }
}

void LockStep::Run() {
    bool has_sent = true;
    while (has_sent) {
        has_sent = false;
        for (auto& peer : peers_) {
            const std::uint64_t before = peer.progress.counters.sent;
            Ask(peer, "go");
            if (peer.progress.counters.sent != before) {
                has_sent = true;
                AwaitRest();
            }
        }
    }
}

std::uint64_t LockStep::NextAfter(std::uint64_t time) const {
    std::uint64_t next = std::numeric_limits<std::uint64_t>::max();
    for (const auto& peer : peers_) {
        next = peer.progress.next > time ? std::min(next, peer.progress.next) : next;
    }
    return next;
}

}  // namespace player
