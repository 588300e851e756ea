// Peers that have restarted (PRS_SOMEIPServiceDiscovery, reboot detection).
#ifndef BENCH_DISCOVERY_PEERS_H_
#define BENCH_DISCOVERY_PEERS_H_

#include <cstdint>
#include <map>
#include <utility>

#include "net/endpoint.h"

namespace bench {

// Sessions count from 1; after 65,535 comes 1 again, and the flag that says so is down from then on.
class SessionCounter {
public:
    std::uint16_t Next() noexcept {
        if (++session_ == 0) {
            session_ = 1;
            has_wrapped_ = true;
        }
        return session_;
    }
    bool HasWrapped() const noexcept { return has_wrapped_; }

private:
    std::uint16_t session_ = 0;
    bool has_wrapped_ = false;
};

class Peers {
public:
    // Whether the sender of a message has restarted since its last one. Messages to a group count separately.
    bool HasRebooted(const Endpoint& peer, bool is_multicast, bool reboot_flag, std::uint16_t session) {
        const auto [found, is_new] = last_.try_emplace({peer, is_multicast}, Last{reboot_flag, session});
        const Last before = found->second;
        found->second = {reboot_flag, session};
        return !is_new && reboot_flag && (!before.reboot_flag || session <= before.session);
    }

    // It did, as one of the two ways has shown: the other one begins again too.
    void Forget(const Endpoint& peer, bool is_multicast) { last_.erase({peer, !is_multicast}); }

private:
    struct Last {
        bool reboot_flag;
        std::uint16_t session;
    };

    std::map<std::pair<Endpoint, bool>, Last> last_;
};

}  // namespace bench

#endif  // BENCH_DISCOVERY_PEERS_H_
