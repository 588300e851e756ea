#include "application/clock.h"

#include <chrono>
#include <limits>

namespace application {

std::uint64_t SteadyClock::Now() const {
    const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(since_start).count());
}

bool SteadyClock::WaitUntil(std::uint64_t time) {
    std::unique_lock<std::mutex> lock{mutex_};
    const auto has_changed = [this] { return is_woken_ || is_stopped_; };
    constexpr auto latest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (time > latest) {
        changed_.wait(lock, has_changed);
    } else {
        const std::chrono::nanoseconds since_start{static_cast<std::int64_t>(time)};
        const std::chrono::time_point<std::chrono::steady_clock, std::chrono::nanoseconds> end{since_start};
        changed_.wait_until(lock, end, has_changed);
    }
    is_woken_ = false;
    return !is_stopped_;
}

void SteadyClock::Wake() {
    {
        const std::lock_guard<std::mutex> lock{mutex_};
        is_woken_ = true;
    }
    changed_.notify_all();
}

void SteadyClock::Stop() {
    {
        const std::lock_guard<std::mutex> lock{mutex_};
        is_stopped_ = true;
    }
    changed_.notify_all();
}

}  // namespace application
