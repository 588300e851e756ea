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

Trace ReadTrace(const std::string& file) {
    std::ifstream in{file};
    Trace trace;
    std::string line;
    if (!std::getline(in, line)) {
        throw std::runtime_error{file + " cannot be read."};
    }
    trace.columns = Split(line);
    trace.columns.erase(trace.columns.begin());
    while (std::getline(in, line)) {
        auto cells = Split(line);
        const std::uint64_t time = Nanoseconds(cells.front());
        cells.erase(cells.begin());
        trace.rows.push_back({time, std::move(cells)});
    }
    return trace;
}

}  // namespace player
