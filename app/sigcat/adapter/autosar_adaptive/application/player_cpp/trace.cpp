#include "player/trace.h"

#include <fstream>
#include <stdexcept>

namespace player {

namespace {

constexpr std::size_t kDigits = 9;  // of a second, down to ns

std::vector<std::string> Split(const std::string& line) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += line[i++];
        } else if (line[i] == '"') {
            is_quoted = !is_quoted;
        } else if (line[i] == ',' && !is_quoted) {
            cells.emplace_back();
        } else if (line[i] != '\r') {
            cells.back() += line[i];
        }
    }
    return cells;
}

// Exact: a double would not be.
std::uint64_t Nanoseconds(const std::string& seconds) {
    const std::size_t point = seconds.find('.');
    std::string fraction = point == std::string::npos ? "" : seconds.substr(point + 1, kDigits);
    fraction.resize(kDigits, '0');
    return std::stoull(seconds.substr(0, point)) * 1000000000U + std::stoull(fraction);
}

}  // namespace

RowStream::RowStream(std::istream& in) : in_{in} {
    std::string line;
    if (!std::getline(in_, line)) {
        throw std::runtime_error{"There are no columns."};
    }
    columns_ = Split(line);
    columns_.erase(columns_.begin());
}

std::uint64_t RowStream::Time() {
    std::string line;
    if (!has_row_ && end_ == kNever) {
        if (std::getline(in_, line)) {
            row_.cells = Split(line);
            row_.time = Nanoseconds(row_.cells.front());
            row_.cells.erase(row_.cells.begin());
            has_row_ = true;
        } else {
            end_ = row_.time;
        }
    }
    return has_row_ ? row_.time : kNever;
}

Trace ReadTrace(const std::string& file) {
    std::ifstream in{file};
    if (!in.good() || in.peek() == std::ifstream::traits_type::eof()) {
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
