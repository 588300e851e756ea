// Processes that run when the player says so, each in its turn, with nothing under way between them.

#ifndef PLAYER_LOCK_STEP_H
#define PLAYER_LOCK_STEP_H

#include <cstdint>
#include <string>
#include <vector>

#include "player/message.h"

namespace player {

class LockStep final {
public:
    /// Waits for the hello of each component. They take turns in this order.
    LockStep(std::uint16_t port, const std::vector<std::string>& components);

    /// Tells the time. The first one lets the components start.
    void Tell(std::uint64_t time);

    /// Waits until every component is connected with all services that it uses.
    void AwaitConnections();

    /// A component is gone, and is not asked any more. What is sent to it comes nowhere.
    void Forget(const std::string& component);

    /// Waits until all that was sent has come. Throws std::runtime_error if something is lost.
    void AwaitRest();

    /// Lets the components run what is due, until none sends anything more.
    void Run();

    /// The earliest time after this one at which a component wants to run.
    std::uint64_t NextAfter(std::uint64_t time) const;

private:
    struct Peer final {
        std::string name;
        std::uint16_t port{0};
        Progress progress;
    };

    struct Sums final {
        std::uint64_t sent{0};
        std::uint64_t received{0};
        std::uint64_t running{0};
        bool operator==(const Sums& other) const {
            return sent == other.sent && received == other.received && running == other.running;
        }
    };

    void Ask(Peer& peer, const std::string& what);
    Sums Count();
    bool IsAtRest();

    Socket socket_;
    std::vector<Peer> peers_;
    std::uint64_t number_{0};
    bool is_complete_{true};
};

}  // namespace player

#endif  // PLAYER_LOCK_STEP_H
