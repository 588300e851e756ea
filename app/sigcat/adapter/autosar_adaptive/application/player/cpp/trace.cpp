#include "player/trace.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "player/cell.h"

namespace player {

RowStream::RowStream(std::istream& in) : in_{in} {
    if (!ReadLine(columns_) || columns_.front() != "time_ns") {
        throw std::runtime_error{"line 1: the trace must be normalized, with time_ns first: sigcat normalize writes it."};
    }
    columns_.erase(columns_.begin());
}

bool RowStream::ReadLine(std::vector<std::string>& cells) {
    std::string line;
    if (!std::getline(in_, line)) {
        return false;
    }
    ++row_.line;
    if (in_.eof()) {
        throw std::runtime_error{"line " + std::to_string(row_.line) + ": it must end with a line break."};
    }
    cells.clear();
    std::istringstream rest{line + '\t'};
    for (std::string cell; std::getline(rest, cell, '\t');) {
        cells.push_back(cell);
    }
    return true;
}

void RowStream::ReadRow() {
    const std::uint64_t last = row_.time;
    try {
        row_.time = ReadAll<std::uint64_t>(row_.cells.front());
        row_.cells.erase(row_.cells.begin());
        if (row_.cells.size() != columns_.size() || row_.time < last) {
            throw std::runtime_error{"it must have all cells, and a time that does not go back."};
        }
    } catch (const std::runtime_error& error) {
        throw std::runtime_error{"line " + std::to_string(row_.line) + ": " + error.what()};
    }
}

std::uint64_t RowStream::Time() {
    if (!has_row_ && end_ == kNever) {
        has_row_ = ReadLine(row_.cells);
        if (has_row_) {
            ReadRow();
        } else {
            end_ = row_.time;
        }
    }
    return has_row_ ? row_.time : kNever;
}

Trace ReadTrace(const std::string& file) {
    std::ifstream in{file};
    if (!in.good()) {
        throw std::runtime_error{file + " cannot be read."};
    }
    RowStream rows{in};
    Trace trace{rows.Columns(), {}};
    for (; rows.Time() != kNever; rows.Advance()) {
        trace.rows.push_back(rows.Row());
    }
    return trace;
}

}  // namespace player
