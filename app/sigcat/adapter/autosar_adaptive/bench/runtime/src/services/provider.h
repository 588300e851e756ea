// The providing side of all services: offers in their phases, subscribers, events sent, requests taken.
#ifndef BENCH_SERVICES_PROVIDER_H_
#define BENCH_SERVICES_PROVIDER_H_

#include <map>
#include <memory>

#include "discovery/entry.h"
#include "services/provided_instance.h"

namespace bench {

class Runtime;

class Provider {
public:
    explicit Provider(Runtime& runtime) noexcept : runtime_{runtime} {}

    // For skeletons.
    ara::core::Result<void> Offer(const std::shared_ptr<ProvidedInstance>& instance);
    void StopOffer(ProvidedInstance& instance);
    void StopAll();
    void Send(ProvidedInstance& instance, const EventDescription& event, ByteView value);
    std::size_t Subscribers(const InstanceKey& key) const;  // processes
    void Reply(const Caller& caller, ReturnCode code, ByteView values);

    // From the network.
    void Answer(const Entry& find, const Endpoint& from, bool is_multicast);
    void TakeSubscription(const Entry& entry, const Endpoint& from);
    void TakeRequest(const Message& message, const Endpoint& from);
    void Lost(const Endpoint& peer);

private:
    using Instance = std::shared_ptr<ProvidedInstance>;

    void Announce(const Instance& instance, std::uint32_t repetition);
    Entry OfferEntry(const ProvidedInstance& instance, std::uint32_t time_to_live) const;
    void Subscribe(const Instance& instance, const Entry& entry, const Endpoint& from);
    void SendInitial(ProvidedInstance& instance, const ProvidedInstance::Subscriber& subscriber);
    void SendInitial(ProvidedInstance& instance, const EventDescription& event, ByteView value, const Endpoint& to);
    void TakeMethod(const Instance& instance, const Message& message, const Endpoint& from);
    void Run(const Instance& instance, ProvidedInstance::Request request);
    void ReplyTo(const Header& request, const Endpoint& to, ReturnCode code, ByteView values);

    Runtime& runtime_;
    std::map<InstanceKey, Instance> offered_;
};

// Of the requests that wait to be processed by hand, and of all others: reads the arguments and calls the handler.
void Process(const ProvidedInstance::Request& request);

}  // namespace bench

#endif  // BENCH_SERVICES_PROVIDER_H_
