// An instance that another process offers, as this process knows and uses it.
#ifndef BENCH_SERVICES_REMOTE_SERVICE_H_
#define BENCH_SERVICES_REMOTE_SERVICE_H_

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "net/endpoint.h"
#include "net/timers.h"
#include "services/event_queue.h"
#include "someip/message.h"

namespace bench {

using Answer = std::function<void(const ara::core::Result<ByteView>&)>;

struct RemoteService {
    struct Offer {
        Endpoint endpoint;
        Endpoint peer;  // its service discovery
        std::uint8_t major_version;
        std::optional<Timers::Id> expiry;
    };
    struct Call {
        std::uint16_t method;
        const ServiceDescription* service;
        Answer answer;
    };

    struct Latest {
        Header header;
        Bytes payload;
    };

    std::optional<Offer> offer{};
    std::vector<std::shared_ptr<EventQueue>> queues{};
    std::set<std::uint16_t> begun{};          // groups that were subscribed to since it was offered
    std::set<std::uint16_t> acknowledged{};   // groups
    std::map<std::uint16_t, Latest> latest{};  // of fields, for who subscribes after another one
    std::map<std::uint16_t, Call> calls{};    // by session
    std::optional<Timers::Id> renewal{};

    bool IsOfferedBy(const Endpoint& endpoint) const { return offer.has_value() && offer->endpoint == endpoint; }
    bool IsKnownFrom(const Endpoint& peer) const { return offer.has_value() && offer->peer == peer; }
    // Groups of the events that have subscribers.
    std::set<std::uint16_t> Groups() const {
        std::set<std::uint16_t> groups;
        for (const auto& queue : queues) {
            groups.insert(queue->Event().group);
        }
        return groups;
    }
};

}  // namespace bench

#endif  // BENCH_SERVICES_REMOTE_SERVICE_H_
