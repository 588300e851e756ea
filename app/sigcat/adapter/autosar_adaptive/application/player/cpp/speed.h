// How fast a drive is played, and the clocks of components with it.

#ifndef PLAYER_SPEED_H
#define PLAYER_SPEED_H

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace player {

/// How many times faster than the clock: what `text` says; 1 without a text. Ends the process if it is not such a number.
inline double Speed(const char* text) {
    if (text == nullptr) {
        return 1.0;
    }
    char* end = nullptr;
    const double speed = std::strtod(text, &end);
    if (end == text || *end != '\0' || !(speed >= 0.001 && speed <= 1000.0)) {
        std::fprintf(stderr, "player: the speed must be a number from 0.001 to 1000, not %s\n", text);
        std::exit(EXIT_FAILURE);
    }
    return speed;
}

/// What BENCH_SPEED says.
inline double Speed() { return Speed(std::getenv("BENCH_SPEED")); }

/// Time on the clock that a time of the drive takes.
inline std::chrono::nanoseconds OnTheClock(std::uint64_t time, double speed) {
    const auto whole = static_cast<std::int64_t>(time);
    return std::chrono::nanoseconds{speed == 1.0 ? whole : static_cast<std::int64_t>(static_cast<double>(whole) / speed)};
}

/// Time of the drive that a time on the clock is.
inline std::uint64_t OfTheDrive(std::chrono::nanoseconds time, double speed) {
    const auto whole = time.count();
    return static_cast<std::uint64_t>(speed == 1.0 ? whole : static_cast<std::int64_t>(static_cast<double>(whole) * speed));
}

}  // namespace player

#endif  // PLAYER_SPEED_H
