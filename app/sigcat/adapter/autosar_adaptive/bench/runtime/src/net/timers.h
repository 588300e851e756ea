// Actions to run later.
#ifndef BENCH_NET_TIMERS_H_
#define BENCH_NET_TIMERS_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace bench {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

class Timers {
public:
    using Id = std::pair<Clock::time_point, std::uint64_t>;

    Id Add(Clock::time_point at, std::function<void()> action);
    Id After(Milliseconds delay, std::function<void()> action);
    void Cancel(const Id& timer) { actions_.erase(timer); }
    void Clear() { actions_.clear(); }

    std::optional<Clock::time_point> Next() const;
    void RunDue(Clock::time_point now);

private:
    std::map<Id, std::function<void()>> actions_;
    std::uint64_t added_ = 0;
};

}  // namespace bench

#endif  // BENCH_NET_TIMERS_H_
