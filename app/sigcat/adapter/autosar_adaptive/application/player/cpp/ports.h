// The services of the player: it offers what no component provides, and uses what components provide.

#ifndef PLAYER_PORTS_H
#define PLAYER_PORTS_H

#include <chrono>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "player/cell.h"
#include "player/times.h"

namespace player {

/// Writes received values: a line of time, name and value.
class Recorder final {
public:
    /// `is_read` by another program while it is written: it reports the actions of the player.
    Recorder(const std::string& file, bool is_read);
    void Begin(std::uint64_t time);  // earlier values are left out
    void BeginNow(double speed = 1.0);  // and times are those of the clock from then on, so many times faster
    void SetTime(std::uint64_t time);
    /// `sent_at` is a time of the steady clock, if the sender tells it: then that is the time of the value.
    /// False before the beginning: the value is not recorded.
    bool Take(const char* name, const std::string& value, std::optional<std::uint64_t> sent_at);
    void Say(const std::string& line);  // to the program that reads
    void TimeIn(const std::string& file);  // when rows are sent and values come
    void TellSent(std::uint64_t row);

private:
    std::uint64_t TimeOf(std::optional<std::uint64_t> sent_at) const;

    std::mutex mutex_;
    Times times_;
    std::ofstream out_;
    bool is_read_;
    std::uint64_t time_{0};
    std::chrono::steady_clock::time_point start_{};
    double speed_{1.0};
    bool is_live_{false};
    bool has_begun_{false};
};

class Ports final {
public:
    explicit Ports(Recorder& recorder);
    ~Ports();
    Ports(const Ports&) = delete;
    Ports& operator=(const Ports&) = delete;

    /// Gives a signal, or a field, a value. False if none of these functions receives one of this name.
    bool Send(const std::string& name, const std::string& cell);

    /// Whether anybody of these functions receives what has this name.
    bool Has(const std::string& name) const { return senders_.count(name) != 0; }

    /// Whether each process has subscribed to what it uses of this one.
    bool AreHeard() const;

    void Offer();
    void Find();
    void Leave();

    /// Names of the components, in the order of their turns.
    static const std::vector<std::string>& Components();

private:
    struct Services;

    std::unique_ptr<Services> services_;
    std::map<std::string, std::function<void(const std::string&)>> senders_;
};

}  // namespace player

#endif  // PLAYER_PORTS_H
