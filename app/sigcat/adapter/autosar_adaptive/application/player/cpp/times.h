// When rows were sent and values came, by the clock of the machine: for whoever measures from one end to the other.

#ifndef PLAYER_TIMES_H
#define PLAYER_TIMES_H

#include <chrono>
#include <cstdint>
#include <fstream>
#include <string>

namespace player {

/// Nothing is written until it is opened.
class Times final {
public:
    void Open(const std::string& file) {
        out_.open(file);
        out_ << "at,name,row\n";
    }

    /// A row was sent that has this time in its trace.
    void TellSent(std::uint64_t row) { Tell("," + std::to_string(row)); }

    /// A value came.
    void TellHeard(const std::string& name) { Tell(name + ","); }

private:
    void Tell(const std::string& what) {
        if (out_.is_open()) {
            const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
            out_ << std::chrono::duration_cast<std::chrono::nanoseconds>(since_start).count() << ',' << what << '\n';
        }
    }

    std::ofstream out_;
};

}  // namespace player

#endif  // PLAYER_TIMES_H
