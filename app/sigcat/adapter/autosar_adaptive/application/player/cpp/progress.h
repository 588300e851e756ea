// How much of a drive was played, for whoever waits at a terminal.

#ifndef PLAYER_PROGRESS_H
#define PLAYER_PROGRESS_H

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>

namespace player {

class ProgressLine final {
public:
    explicit ProgressLine(std::uint64_t end) : end_{end} {}

    /// A row of this time is sent.
    void Reach(std::uint64_t time) {
        const auto now = std::chrono::steady_clock::now();
        if (is_shown_ && (now - shown_ >= std::chrono::seconds{1} || time >= end_)) {
            shown_ = now;
            std::fprintf(stderr, "\rplayer: %.0f of %.0f s%s", Seconds(time), Seconds(end_), time >= end_ ? "\n" : "");
            std::fflush(stderr);
        }
    }

private:
    static double Seconds(std::uint64_t time) { return static_cast<double>(time) / 1e9; }

    std::uint64_t end_;
    bool is_shown_{isatty(STDERR_FILENO) == 1};
    std::chrono::steady_clock::time_point shown_{};
};

}  // namespace player

#endif  // PLAYER_PROGRESS_H
