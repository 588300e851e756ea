// A drive: CSV with a column for the time, in seconds, and one for each signal.

#ifndef PLAYER_TRACE_H
#define PLAYER_TRACE_H

#include <cstdint>
#include <istream>
#include <limits>
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

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

/// Rows that come one after the other, from a program that writes them.
class RowStream final {
public:
    /// Reads the columns. Throws std::runtime_error if there are none.
    explicit RowStream(std::istream& in);

    const std::vector<std::string>& Columns() const { return columns_; }
    const player::Row& Row() const { return row_; }

    /// The time of the row that is next, kNever after the last one: waits for it.
    std::uint64_t Time();
    void Advance() { has_row_ = false; }

    /// When the drive ends: not known before the last row has been read.
    std::uint64_t End() const { return end_; }

private:
    std::istream& in_;
    std::vector<std::string> columns_;
    player::Row row_{};
    bool has_row_{false};
    std::uint64_t end_{kNever};
};

/// Throws std::runtime_error if the file cannot be read.
Trace ReadTrace(const std::string& file);

}  // namespace player

#endif  // PLAYER_TRACE_H
