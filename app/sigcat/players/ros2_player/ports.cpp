#include "player/ports.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace player {

namespace {

std::string CsvCell(const std::string& text) {
    std::string quoted = "\"";
    for (const char each : text) {
        quoted += each == '"' ? "\"\"" : std::string(1, each);
    }
    return quoted + "\"";
}

}  // namespace

Record::Record(const std::string& file, std::size_t nodes, bool is_read)
    : out_{file}, is_read_{is_read}, heard_(nodes), given_(nodes) {
    out_ << "time,name,value\n";
}

void Record::Hear(
    std::size_t node, const Takers& takers, const std::vector<std::pair<const char*, std::string>>& values,
    std::int64_t stamp) {
    {
        const std::lock_guard<std::mutex> lock{mutex_};
        if (gone_.count(node) != 0) {
            return;
        }
        ++heard_[node];
        for (const std::size_t taker : takers) {
            ++given_[taker];
        }
        const std::uint64_t time = begin_ + static_cast<std::uint64_t>(std::max<std::int64_t>(0, stamp - epoch_));
        for (const auto& each : values) {
            out_ << time << ',' << each.first << ',' << CsvCell(each.second) << '\n';
            times_.TellHeard(each.first);
        }
        out_.flush();  // it is there, too, when the player is ended before the drive
    }
    changed_.notify_all();
}

void Record::Give(const Takers& takers) {
    const std::lock_guard<std::mutex> lock{mutex_};
    for (const std::size_t taker : takers) {
        ++given_[taker];
    }
}

void Record::Say(const std::string& line) {
    if (is_read_) {
        const std::lock_guard<std::mutex> lock{mutex_};
        out_ << line << std::endl;
    }
}

void Record::TimeIn(const std::string& file) {
    const std::lock_guard<std::mutex> lock{mutex_};
    times_.Open(file);
}

void Record::TellSent(std::uint64_t row) {
    const std::lock_guard<std::mutex> lock{mutex_};
    times_.TellSent(row);
}

void Record::Forget(std::size_t node) {
    const std::lock_guard<std::mutex> lock{mutex_};
    gone_.insert(node);
}

std::uint64_t Record::Given(std::size_t node) const {
    const std::lock_guard<std::mutex> lock{mutex_};
    return given_[node];
}

std::uint64_t Record::GivenInAll() const {
    const std::lock_guard<std::mutex> lock{mutex_};
    std::uint64_t sum = 0;
    for (std::size_t node = 0; node < given_.size(); ++node) {
        sum += gone_.count(node) != 0 ? 0 : given_[node];
    }
    return sum;
}

bool Record::AwaitHeard(std::size_t node, std::uint64_t count) {
    std::unique_lock<std::mutex> lock{mutex_};
    return changed_.wait_for(lock, kPatience, [this, node, count] { return heard_[node] >= count; });
}

bool Ports::Set(const std::string& name, const std::string& cell) {
    const auto column = columns_.find(name);
    if (column == columns_.end()) {
        return false;
    }
    column->second(cell);
    return true;
}

void Ports::Publish(std::int64_t stamp) {
    for (const auto& out : outs_) {
        if (out->is_filled) {
            record_.Give(out->Nodes());
            out->Publish(stamp);
            out->is_sent = true;
        }
    }
}

bool Ports::Repeats() const {
    return std::any_of(outs_.begin(), outs_.end(), [](const auto& out) { return out->is_filled && out->is_sent; });
}

void Ports::Forget() {
    for (const auto& out : outs_) {
        out->is_sent = false;
    }
}

bool Ports::AreConnected() const {
    return std::all_of(outs_.begin(), outs_.end(),
                       [](const auto& out) { return out->Subscriptions() >= out->Nodes().size(); });
}

}  // namespace player
