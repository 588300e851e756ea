#include "player/ports.h"

#include <algorithm>

#include "player/speed.h"

namespace player {

Recorder::Recorder(const std::string& file, bool is_read) : out_{file}, is_read_{is_read} { out_ << "time,name,value\n"; }

void Recorder::Begin(std::uint64_t time) {
    const std::lock_guard<std::mutex> lock{mutex_};
    time_ = time;
    has_begun_ = true;
}

void Recorder::BeginNow(double speed) {
    const std::lock_guard<std::mutex> lock{mutex_};
    start_ = std::chrono::steady_clock::now();
    speed_ = speed;
    is_live_ = true;
    has_begun_ = true;
}

void Recorder::SetTime(std::uint64_t time) {
    const std::lock_guard<std::mutex> lock{mutex_};
    time_ = time;
}

std::uint64_t Recorder::TimeOf(std::optional<std::uint64_t> sent_at) const {
    if (!is_live_) {
        return time_;
    }
    const std::chrono::nanoseconds passed = std::chrono::steady_clock::now() - start_;
    const std::chrono::nanoseconds start = start_.time_since_epoch();
    const auto now = static_cast<std::uint64_t>(passed.count());
    const auto begin = static_cast<std::uint64_t>(start.count());
    const auto taken = sent_at.has_value() ? std::min(now, *sent_at - std::min(*sent_at, begin)) : now;
    return OfTheDrive(std::chrono::nanoseconds{static_cast<std::int64_t>(taken)}, speed_);
}

bool Recorder::Take(const char* name, const std::string& value, std::optional<std::uint64_t> sent_at) {
    const std::lock_guard<std::mutex> lock{mutex_};
    if (!has_begun_) {
        return false;
    }
    times_.TellHeard(name);
    out_ << TimeOf(sent_at) << ',' << name << ",\"";
    for (const char each : value) {
        out_ << (each == '"' ? "\"\"" : std::string(1, each));
    }
    out_ << "\"\n" << std::flush;  // it is there, too, when the player is ended before the drive
    return true;
}

void Recorder::TimeIn(const std::string& file) {
    const std::lock_guard<std::mutex> lock{mutex_};
    times_.Open(file);
}

void Recorder::TellSent(std::uint64_t row) {
    const std::lock_guard<std::mutex> lock{mutex_};
    times_.TellSent(row);
}

void Recorder::Say(const std::string& line) {
    if (!is_read_) {
        return;
    }
    const std::lock_guard<std::mutex> lock{mutex_};
    out_ << line << std::endl;
}

}  // namespace player
