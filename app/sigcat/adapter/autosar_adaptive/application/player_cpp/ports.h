// The services of the player: it offers what no component provides, and uses what components provide.

#ifndef PLAYER_PORTS_H
#define PLAYER_PORTS_H

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "player/cell.h"

namespace player {

/// Writes what comes: a line of time, name and value.
class Recorder final {
public:
    explicit Recorder(const std::string& file);
    void Begin(std::uint64_t time);  // what came before is left out
    void SetTime(std::uint64_t time);
    void Take(const char* name, const std::string& value);

private:
    std::mutex mutex_;
    std::ofstream out_;
    std::uint64_t time_{0};
    bool has_begun_{false};
};

class Ports final {
public:
    explicit Ports(Recorder& recorder);
    ~Ports();
    Ports(const Ports&) = delete;
    Ports& operator=(const Ports&) = delete;

    /// Gives a signal, or a field, a value. False if nobody of these functions receives one of this name.
    bool Send(const std::string& name, const std::string& cell);

    void Offer();
    void Find();
    void Leave();

    /// Names of the components, in the order of their turns.
    static const std::vector<std::string>& Components();

private:
    struct Services;

    std::unique_ptr<Services> services_;
    std::map<std::string, std::function<void(const Item&)>> senders_;
};

}  // namespace player

#endif  // PLAYER_PORTS_H
