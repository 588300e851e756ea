// An instance that this process offers.
#ifndef BENCH_SERVICES_PROVIDED_INSTANCE_H_
#define BENCH_SERVICES_PROVIDED_INSTANCE_H_

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "bench/skeleton_connection.h"
#include "discovery/peers.h"
#include "net/endpoint.h"
#include "net/timers.h"
#include "services/instance_key.h"
#include "someip/message.h"

namespace bench {

// Who asked, and what: kept until it is answered.
struct Caller {
    std::weak_ptr<ProvidedInstance> instance;
    Header request;
    Endpoint from;
};

class ProvidedInstance {
public:
    struct Subscriber {
        std::uint16_t group;
        std::uint8_t counter;
        Endpoint endpoint;
        Endpoint peer;  // its service discovery
        std::optional<Clock::time_point> end;
    };
    struct Request {
        std::shared_ptr<const SkeletonConnection::Handler> handler;
        std::shared_ptr<const Caller> caller;
        Bytes arguments;
    };

    ProvidedInstance(const ServiceDescription& description, std::uint16_t instance,
                     ara::com::MethodCallProcessingMode processing)
        : service{description}, key{description.id, instance}, mode{processing} {}

    const ServiceDescription& service;
    const InstanceKey key;
    const ara::com::MethodCallProcessingMode mode;

    bool is_offered = false;
    bool is_announced = false;  // past the initial wait, in which no request is answered
    std::optional<Timers::Id> timer{};
    std::vector<Subscriber> subscribers{};

    std::map<std::uint16_t, SessionCounter> sessions{};  // by event
    std::map<std::uint16_t, std::uint32_t> counters{};   // of protected events
    std::map<std::uint16_t, Bytes> values{};             // of fields, by notifier
    std::map<std::uint16_t, Bytes> payloads{};           // that were sent last, of protected fields
    std::map<std::uint16_t, Header> headers{};           // of these payloads
    std::map<std::uint16_t, std::uint16_t> fields{};     // notifiers to getters, or 0
    std::map<std::uint16_t, std::uint16_t> getters{};    // to notifiers
    std::set<std::uint16_t> setters{};
    std::map<std::uint16_t, std::shared_ptr<const SkeletonConnection::Handler>> handlers{};  // by method
    std::deque<Request> waiting{};                                                           // to be processed by hand

    Header EventHeader(std::uint16_t event) {
        const std::uint16_t session = service.counts_sessions ? sessions[event].Next() : std::uint16_t{0};
        return {service.id,
                event,
                0,
                session,
                kProtocolVersion,
                service.major_version,
                static_cast<std::uint8_t>(MessageType::kNotification),
                ReturnCode::kOk};
    }
};

}  // namespace bench

#endif  // BENCH_SERVICES_PROVIDED_INSTANCE_H_
