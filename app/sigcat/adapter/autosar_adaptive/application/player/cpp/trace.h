// A normalized trace, as `sigcat normalize` writes it: rows of a time in ns and of values.

#ifndef PLAYER_TRACE_H
#define PLAYER_TRACE_H

#include <cstdint>
#include <istream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace player {

struct Row final {
    std::uint64_t time;
    std::uint64_t line;
    std::vector<std::string> cells;
};

struct Trace final {
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();

/// Rows that come one after the other, from a program that writes them. Throws std::runtime_error at a damaged one.
class RowStream final {
public:
    /// Reads the columns.
    explicit RowStream(std::istream& in);

    const std::vector<std::string>& Columns() const { return columns_; }
    const player::Row& Row() const { return row_; }

    /// The time of the row that is next, kNever after the last one: waits for it.
    std::uint64_t Time();
    void Advance() { has_row_ = false; }

    /// When the drive ends: not known before the last row has been read.
    std::uint64_t End() const { return end_; }

private:
    bool ReadLine(std::vector<std::string>& cells);
    void ReadRow();

    std::istream& in_;
    std::vector<std::string> columns_;
    player::Row row_{};
    bool has_row_{false};
    std::uint64_t end_{kNever};
};

/// Gives the cells of a row that are not empty to `send(name, cell)`. Returns how many it took; its errors have the line.
template <typename SendT>
std::uint64_t SendCells(const std::vector<std::string>& columns, const Row& row, SendT send) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        try {
            count += !row.cells[i].empty() && send(columns[i], row.cells[i]) ? 1U : 0U;
        } catch (const std::runtime_error& error) {
            throw std::runtime_error{"line " + std::to_string(row.line) + ": " + columns[i] + ": " + error.what()};
        }
    }
    return count;
}

/// Throws std::runtime_error if the file cannot be read.
Trace ReadTrace(const std::string& file);

}  // namespace player

#endif  // PLAYER_TRACE_H
