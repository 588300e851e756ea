// The consuming side of all services: offers that come and go, subscriptions, events and answers.
#ifndef BENCH_SERVICES_CONSUMER_H_
#define BENCH_SERVICES_CONSUMER_H_

#include <map>
#include <memory>

#include "bench/find_service.h"
#include "discovery/entry.h"
#include "services/instance_key.h"
#include "services/remote_service.h"
#include "someip/message.h"

namespace bench {

class Runtime;

class Consumer {
public:
    explicit Consumer(Runtime& runtime) noexcept : runtime_{runtime} {}

    // For proxies.
    Handles Found(const ServiceDescription& service, std::uint16_t instance) const;
    void Subscribe(const std::shared_ptr<EventQueue>& queue);
    void Unsubscribe(const std::shared_ptr<EventQueue>& queue);
    // False if the service is not available: no answer will arrive.
    bool Call(const Handle& handle, std::uint16_t method, ByteView arguments, Answer answer);

    // From the network.
    void TakeOffer(const Entry& entry, const Endpoint& from, bool is_multicast);
    void TakeAcknowledgement(const Entry& entry, const Endpoint& from);
    void TakeEvent(const Message& message, const Endpoint& from);
    void TakeAnswer(const Message& message, const Endpoint& from);
    void Lost(const Endpoint& peer);
    void Clear();

    // How many subscriptions are not acknowledged.
    std::size_t Missing() const;

private:
    using Remotes = std::map<InstanceKey, RemoteService>;

    RemoteService* OfferedBy(std::uint16_t service, const Endpoint& endpoint);
    void Renew(const InstanceKey& key, RemoteService& remote, bool is_multicast);
    void SendSubscription(const InstanceKey& key, const RemoteService& remote, const ServiceDescription& service,
                          std::uint16_t group, std::uint32_t time_to_live);
    void BeginSubscription(const InstanceKey& key, RemoteService& remote, const ServiceDescription& service,
                           std::uint16_t group);
    void SendSubscriptions(const InstanceKey& key, RemoteService& remote);
    void Withdraw(const InstanceKey& key, RemoteService& remote);
    void Fail(RemoteService& remote);

    Runtime& runtime_;
    Remotes remotes_;
    std::uint16_t session_ = 0;
};

}  // namespace bench

#endif  // BENCH_SERVICES_CONSUMER_H_
