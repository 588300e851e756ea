#include "services/provider.h"

#include <algorithm>
#include <set>
#include <utility>

#include "ara/com/com_error_domain.h"
#include "discovery/discovery_message.h"
#include "e2e/protection.h"
#include "services/runtime.h"

namespace bench {
namespace {

using ara::com::ComErrc;
using ara::com::MethodCallProcessingMode;

constexpr std::size_t kMostSubscribers = 1000;  // what others send must not take all memory
constexpr std::size_t kMostWaiting = 1000;

bool HasGroup(const ServiceDescription& service, std::uint16_t group) {
    return std::any_of(service.events.begin(), service.events.end(),
                       [group](const EventDescription& event) { return event.group == group; });
}

template <typename Subscribers, typename Condition>
void Remove(Subscribers& subscribers, Condition condition) {
    subscribers.erase(std::remove_if(subscribers.begin(), subscribers.end(), condition), subscribers.end());
}

}  // namespace

ara::core::Result<void> Provider::Offer(const Instance& instance) {
    if (instance->is_offered) {
        return {};
    }
    // Messages name a service, not its instance: a second instance would need its own port.
    const auto same = [&instance](const auto& other) { return other.first.first == instance->key.first; };
    if (!runtime_.IsRunning() || std::any_of(offered_.begin(), offered_.end(), same)) {
        return ara::core::Result<void>::FromError(ComErrc::kNetworkBindingFailure);
    }
    for (const auto& [notifier, getter] : instance->fields) {
        if (instance->values.count(notifier) == 0 && instance->handlers.count(getter) == 0) {
            return ara::core::Result<void>::FromError(ComErrc::kFieldValueIsNotValid);
        }
    }
    for (const auto setter : instance->setters) {
        if (instance->handlers.count(setter) == 0) {
            return ara::core::Result<void>::FromError(ComErrc::kSetHandlerNotSet);
        }
    }
    instance->is_offered = true;
    offered_.emplace(instance->key, instance);
    const auto& times = instance->service.times;
    instance->timer = runtime_.Later().After(runtime_.Between(times.initial_delay_min, times.initial_delay_max),
                                             [this, instance] { Announce(instance, 0); });
    runtime_.Wake();
    return {};
}

void Provider::StopOffer(ProvidedInstance& instance) {
    if (!instance.is_offered) {
        return;
    }
    if (instance.timer.has_value()) {
        runtime_.Later().Cancel(*instance.timer);
    }
    if (instance.is_announced) {
        runtime_.Discovery().Add(kDiscoveryGroup, OfferEntry(instance, 0));
        runtime_.Wake();
    }
    instance.is_offered = false;
    instance.is_announced = false;
    instance.timer.reset();
    instance.subscribers.clear();
    instance.waiting.clear();
    offered_.erase(instance.key);
}

void Provider::StopAll() {
    while (!offered_.empty()) {
        const Instance instance = offered_.begin()->second;
        StopOffer(*instance);
    }
}

void Provider::Send(ProvidedInstance& instance, const EventDescription& event, ByteView value) {
    const auto now = Clock::now();
    Remove(instance.subscribers, [now](const auto& each) { return each.end.has_value() && *each.end <= now; });
    const Header header = instance.EventHeader(event.id);
    const Bytes payload = Protected(event.protection, instance.counters[event.id], header, value);
    if (event.is_field && event.protection.profile != 0) {
        instance.payloads[event.id] = payload;
        instance.headers[event.id] = header;
    }
    for (const auto& subscriber : instance.subscribers) {
        if (subscriber.group == event.group) {
            runtime_.Send(header, payload, subscriber.endpoint);
        }
    }
}

std::size_t Provider::Subscribers(const InstanceKey& key) const {
    std::set<Endpoint> found;
    const auto instance = offered_.find(key);
    if (instance != offered_.end()) {
        for (const auto& each : instance->second->subscribers) {
            found.insert(each.endpoint);
        }
    }
    return found.size();
}

void Provider::Reply(const Caller& caller, ReturnCode code, ByteView values) {
    const auto instance = caller.instance.lock();
    if (instance != nullptr && instance->is_offered) {
        ReplyTo(caller.request, caller.from, code, values);
    }
}

void Provider::Answer(const Entry& find, const Endpoint& from, bool is_multicast) {
    for (const auto& [key, instance] : offered_) {
        const auto& service = instance->service;
        const bool is_meant =
            instance->is_announced && find.service == key.first &&
            (find.instance == kAnyInstance || find.instance == key.second) &&
            (find.major_version == kAnyMajorVersion || find.major_version == service.major_version) &&
            (find.minor_version == kAnyMinorVersion || find.minor_version == service.minor_version);
        if (!is_meant) {
            continue;
        }
        const auto delay = is_multicast
                               ? runtime_.Between(service.times.response_delay_min, service.times.response_delay_max)
                               : Milliseconds{0};
        runtime_.Later().After(delay, [this, from, instance = instance] {
            if (instance->is_offered) {
                runtime_.Discovery().Add(from, OfferEntry(*instance, instance->service.times.offer_time_to_live));
            }
        });
    }
}

void Provider::TakeSubscription(const Entry& entry, const Endpoint& from) {
    const auto found = offered_.find({entry.service, entry.instance});
    if (entry.time_to_live == 0) {
        if (found != offered_.end()) {
            Remove(found->second->subscribers, [&](const auto& each) {
                return each.group == entry.group && each.counter == entry.counter && each.peer == from;
            });
        }
        return;
    }
    Entry answer = entry;
    answer.type = EntryType::kSubscribeAck;
    answer.endpoint.reset();
    const bool is_accepted = found != offered_.end() && found->second->is_announced &&
                             found->second->service.major_version == entry.major_version &&
                             HasGroup(found->second->service, entry.group) && entry.endpoint.has_value() &&
                             entry.endpoint->IsLoopback() && found->second->subscribers.size() < kMostSubscribers;
    if (!is_accepted) {
        answer.time_to_live = 0;
    }
    runtime_.Discovery().Add(from, answer);
    if (is_accepted) {
        Subscribe(found->second, entry, from);
    }
}

void Provider::TakeRequest(const Message& message, const Endpoint& from) {
    const Header& header = message.header;
    const auto found = std::find_if(offered_.begin(), offered_.end(),
                                    [&header](const auto& each) { return each.first.first == header.service; });
    if (header.protocol_version != kProtocolVersion) {
        ReplyTo(header, from, ReturnCode::kWrongProtocolVersion, {});
    } else if (found == offered_.end()) {
        ReplyTo(header, from, ReturnCode::kUnknownService, {});
    } else if (header.interface_version != found->second->service.major_version) {
        ReplyTo(header, from, ReturnCode::kWrongInterfaceVersion, {});
    } else {
        TakeMethod(found->second, message, from);
    }
}

void Provider::Lost(const Endpoint& peer) {
    for (const auto& [key, instance] : offered_) {
        Remove(instance->subscribers, [&peer](const auto& each) { return each.peer == peer; });
    }
}

void Provider::Announce(const Instance& instance, std::uint32_t repetition) {
    const auto& times = instance->service.times;
    instance->is_announced = true;
    instance->timer.reset();
    runtime_.Discovery().Add(kDiscoveryGroup, OfferEntry(*instance, times.offer_time_to_live));
    const bool is_repetition = repetition < times.repetitions_max;
    const Milliseconds delay{is_repetition ? times.repetitions_base_delay * static_cast<double>(1ULL << repetition)
                                           : times.offer_cyclic_delay};
    if (delay.count() > 0) {
        const std::uint32_t next = is_repetition ? repetition + 1 : repetition;
        instance->timer = runtime_.Later().After(delay, [this, instance, next] { Announce(instance, next); });
    }
}

Entry Provider::OfferEntry(const ProvidedInstance& instance, std::uint32_t time_to_live) const {
    Entry entry{EntryType::kOffer, instance.key.first, instance.key.second, instance.service.major_version,
                time_to_live};
    entry.minor_version = instance.service.minor_version;
    entry.endpoint = runtime_.ServiceEndpoint();
    return entry;
}

void Provider::Subscribe(const Instance& instance, const Entry& entry, const Endpoint& from) {
    ProvidedInstance::Subscriber subscriber{entry.group, entry.counter, *entry.endpoint, from, std::nullopt};
    const auto now = Clock::now();
    if (entry.time_to_live != kForEver) {
        subscriber.end = now + std::chrono::seconds{entry.time_to_live};
    }
    auto& all = instance->subscribers;
    const auto known = std::find_if(all.begin(), all.end(), [&](const auto& each) {
        return each.group == subscriber.group && each.counter == subscriber.counter &&
               each.endpoint == subscriber.endpoint;
    });
    const bool is_renewed = known != all.end() && (!known->end.has_value() || *known->end > now);
    if (known != all.end()) {
        *known = subscriber;
    } else {
        all.push_back(subscriber);
    }
    if (!is_renewed) {
        // After the acknowledgement, which is on its way then.
        runtime_.Discovery().Afterwards([this, instance, subscriber] { SendInitial(*instance, subscriber); });
    }
}

void Provider::SendInitial(ProvidedInstance& instance, const ProvidedInstance::Subscriber& subscriber) {
    for (const auto& event : instance.service.events) {
        const auto value = instance.values.find(event.id);
        if (event.group == subscriber.group && instance.is_offered && value != instance.values.end()) {
            SendInitial(instance, event, value->second, subscriber.endpoint);
        }
    }
}

// A protected value is sent as it was before: a separate counter would be a lost message for all others.
void Provider::SendInitial(ProvidedInstance& instance, const EventDescription& event, ByteView value,
                           const Endpoint& to) {
    if (event.protection.profile == 0) {
        runtime_.Send(instance.EventHeader(event.id), value, to);
        return;
    }
    if (instance.payloads.count(event.id) == 0) {
        const Header header = instance.EventHeader(event.id);
        instance.payloads[event.id] = Protected(event.protection, instance.counters[event.id], header, value);
        instance.headers[event.id] = header;
    }
    runtime_.Send(instance.headers[event.id], instance.payloads[event.id], to);
}

void Provider::TakeMethod(const Instance& instance, const Message& message, const Endpoint& from) {
    const Header& header = message.header;
    const auto handler = instance->handlers.find(header.method);
    if (handler != instance->handlers.end()) {
        Run(instance, {handler->second, std::make_shared<const Caller>(Caller{instance, header, from}),
                       Bytes{message.payload.begin(), message.payload.end()}});
        return;
    }
    const auto getter = instance->getters.find(header.method);
    if (getter != instance->getters.end()) {
        ReplyTo(header, from, ReturnCode::kOk, instance->values[getter->second]);
        return;
    }
    ReplyTo(header, from, ReturnCode::kUnknownMethod, {});
}

void Provider::Run(const Instance& instance, ProvidedInstance::Request request) {
    if (instance->mode != MethodCallProcessingMode::kPoll) {
        runtime_.Handlers().Post(instance.get(), [request = std::move(request)] { Process(request); });
    } else if (instance->waiting.size() < kMostWaiting) {
        instance->waiting.push_back(std::move(request));
    } else {
        Reply(*request.caller, ReturnCode::kNotReady, {});
    }
}

void Provider::ReplyTo(const Header& request, const Endpoint& to, ReturnCode code, ByteView values) {
    if (!request.Is(MessageType::kRequest)) {
        return;
    }
    Header header = request;
    const auto type = code == ReturnCode::kOk ? MessageType::kResponse : MessageType::kError;
    header.type = static_cast<std::uint8_t>(type);
    header.protocol_version = kProtocolVersion;
    header.code = code;
    runtime_.Send(header, values, to);
}

void Process(const ProvidedInstance::Request& request) {
    const auto instance = request.caller->instance.lock();
    if (instance != nullptr) {
        Reader reader{ByteView{request.arguments}, instance->service.serialization};
        (*request.handler)(reader, Reply{request.caller});
    }
}

}  // namespace bench
