// A recorded drive: a CSV file with a column for the time, in seconds, and one for each signal.

#ifndef PLAYER_TRACE_H
#define PLAYER_TRACE_H

#include <cstdint>
#include <string>
#include <vector>

namespace player {

struct Row final {
    std::uint64_t time;  // ns
    std::vector<std::string> cells;
};

struct Trace final {
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

/// Throws std::runtime_error if the file cannot be read.
Trace ReadTrace(const std::string& file);

}  // namespace player

#endif  // PLAYER_TRACE_H
