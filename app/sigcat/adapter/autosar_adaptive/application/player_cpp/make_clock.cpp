// The clock of a component at the bench: steady, or what the player says.

#include <atomic>
#include <cstdlib>
#include <sstream>
#include <string>

#include "application/clock.h"
#include "bench/counters.h"
#include "player/message.h"

namespace application {

namespace {

constexpr int kPatience = 50;  // ms until it looks whether it is to stop

class LockStepClock final : public Clock {
public:
    LockStepClock(const char* component, std::uint16_t player) : player_{player} {
        std::string text;
        while (!has_begun_) {
            socket_.Send(std::string{"hello "} + component, player_);
            std::uint16_t port = 0;
            if (socket_.Receive(text, port, kPatience)) {
                static_cast<void>(Take(text, 0));
            }
        }
    }

    std::uint64_t Now() const override { return now_.load(); }

    bool WaitUntil(std::uint64_t time) override {
        if (has_run_) {
            Reply(time);
        }
        has_run_ = false;
        std::string text;
        std::uint16_t port = 0;
        while (!is_stopped_.load() && !has_run_) {
            if (socket_.Receive(text, port, kPatience)) {
                has_run_ = Take(text, time);
            }
        }
        return !is_stopped_.load();
    }

    void Wake() override {}  // calls run when it is their turn
    void Stop() override { is_stopped_.store(true); }
    bool IsInTurns() const override { return true; }

private:
    // Whether it says that calls are to run.
    bool Take(const std::string& text, std::uint64_t next) {
        std::istringstream words{text};
        std::uint64_t number = 0;
        std::string what;
        words >> number >> what;
        if (number == number_) {
            socket_.Send(reply_, player_);
            return false;
        }
        number_ = number;
        if (what == "go") {
            return true;
        }
        if (what == "time") {
            std::uint64_t now = 0;
            words >> now;
            now_.store(now);
            has_begun_ = true;
        }
        Reply(next);
        return false;
    }

    void Reply(std::uint64_t next) {
        std::ostringstream text;
        const auto counters = bench::Count();
        text << number_ << ' ' << counters.sent << ' ' << counters.received << ' ' << counters.running << ' '
             << counters.missing << ' ' << next;
        reply_ = text.str();
        socket_.Send(reply_, player_);
    }

    player::Socket socket_{0};
    std::uint16_t player_;
    std::atomic<std::uint64_t> now_{0};
    std::atomic<bool> is_stopped_{false};
    bool has_begun_{false};
    bool has_run_{false};
    std::uint64_t number_{0};
    std::string reply_;
};

}  // namespace

std::unique_ptr<Clock> MakeClock(const char* component) {
    const char* const player = std::getenv("BENCH_PLAYER");
    if (player == nullptr) {
        return std::make_unique<SteadyClock>();
    }
    return std::make_unique<LockStepClock>(component, static_cast<std::uint16_t>(std::atoi(player)));
}

}  // namespace application
