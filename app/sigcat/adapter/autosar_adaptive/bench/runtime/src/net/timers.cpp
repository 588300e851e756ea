#include "net/timers.h"

namespace bench {

Timers::Id Timers::Add(Clock::time_point at, std::function<void()> action) {
    const Id timer{at, ++added_};
    actions_.emplace(timer, std::move(action));
    return timer;
}

Timers::Id Timers::After(Milliseconds delay, std::function<void()> action) {
    return Add(Clock::now() + std::chrono::duration_cast<Clock::duration>(delay), std::move(action));
}

std::optional<Clock::time_point> Timers::Next() const {
    return actions_.empty() ? std::nullopt : std::optional{actions_.begin()->first.first};
}

void Timers::RunDue(Clock::time_point now) {
    while (!actions_.empty() && actions_.begin()->first.first <= now) {
        // Taken out first: an action may add timers, or cancel others.
        auto action = std::move(actions_.extract(actions_.begin()).mapped());
        action();
    }
}

}  // namespace bench
