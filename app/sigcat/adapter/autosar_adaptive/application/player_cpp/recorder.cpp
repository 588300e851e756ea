#include "player/ports.h"

namespace player {

Recorder::Recorder(const std::string& file, bool is_read) : out_{file}, is_read_{is_read} { out_ << "time,name,value\n"; }

void Recorder::Begin(std::uint64_t time) {
    const std::lock_guard<std::mutex> lock{mutex_};
    time_ = time;
    has_begun_ = true;
}

void Recorder::BeginNow() {
    const std::lock_guard<std::mutex> lock{mutex_};
    start_ = std::chrono::steady_clock::now();
    is_live_ = true;
    has_begun_ = true;
}

void Recorder::SetTime(std::uint64_t time) {
    const std::lock_guard<std::mutex> lock{mutex_};
    time_ = time;
}

void Recorder::Take(const char* name, const std::string& value) {
    const std::lock_guard<std::mutex> lock{mutex_};
    if (!has_begun_) {
        return;
    }
    times_.TellHeard(name);
    const std::chrono::nanoseconds passed = is_live_ ? std::chrono::steady_clock::now() - start_ : std::chrono::nanoseconds{0};
    out_ << (is_live_ ? static_cast<std::uint64_t>(passed.count()) : time_) << ',' << name << ",\"";
    for (const char each : value) {
        out_ << (each == '"' ? "\"\"" : std::string(1, each));
    }
    out_ << "\"\n" << std::flush;  // it is there, too, when the player is ended before the drive
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
