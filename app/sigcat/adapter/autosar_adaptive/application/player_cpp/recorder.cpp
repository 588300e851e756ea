#include "player/ports.h"

namespace player {

Recorder::Recorder(const std::string& file) : out_{file} { out_ << "time,name,value\n"; }

void Recorder::Begin(std::uint64_t time) {
    const std::lock_guard<std::mutex> lock{mutex_};
    time_ = time;
    has_begun_ = true;
}

void Recorder::SetTime(std::uint64_t time) {
    const std::lock_guard<std::mutex> lock{mutex_};
    time_ = time;
}

void Recorder::Take(const char* name, const std::string& value) {
    const std::lock_guard<std::mutex> lock{mutex_};
    if (has_begun_) {
        out_ << time_ << ',' << name << ",\"" << value << "\"\n";
    }
}

}  // namespace player
