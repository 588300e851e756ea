// The clock of a component at the bench: steady, or what the player says.

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>

#include "application/clock.h"
#include "bench/counters.h"
#include "player/message.h"
#include "player/speed.h"

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

// A steady clock that is so many times faster, from its beginning on.
class FastClock final : public Clock {
public:
    explicit FastClock(double speed) : speed_{speed}, begin_{clock_.Now()} {}

    std::uint64_t Now() const override {
        return begin_ + player::OfTheDrive(std::chrono::nanoseconds{static_cast<std::int64_t>(clock_.Now() - begin_)}, speed_);
    }

    bool WaitUntil(std::uint64_t time) override {
        constexpr auto latest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
        if (time <= begin_ || time > latest) {
            return clock_.WaitUntil(time);
        }
        return clock_.WaitUntil(begin_ + static_cast<std::uint64_t>(player::OnTheClock(time - begin_, speed_).count()));
    }

    void Wake() override { clock_.Wake(); }
    void Stop() override { clock_.Stop(); }

private:
    SteadyClock clock_;
    double speed_;
    std::uint64_t begin_;
};

}  // namespace

std::unique_ptr<Clock> MakeClock(const char* component) {
    const char* const port = std::getenv("BENCH_PLAYER");
    if (port == nullptr) {
        const double speed = player::Speed();
        return speed == 1.0 ? std::unique_ptr<Clock>{std::make_unique<SteadyClock>()} : std::make_unique<FastClock>(speed);
    }
    return std::make_unique<LockStepClock>(component, static_cast<std::uint16_t>(std::atoi(port)));
}

}  // namespace application
