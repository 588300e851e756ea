#include "services/consumer.h"

#include <algorithm>
#include <utility>

#include "ara/com/com_error_domain.h"
#include "services/runtime.h"
#include "someip/application_error.h"

namespace bench {
namespace {

using ara::com::ComErrc;
using ara::com::SubscriptionState;

constexpr std::size_t kMostRemotes = 10'000;  // offers of others must not take all memory

InstanceKey KeyOf(const Handle& handle) { return {handle.Service().id, handle.Instance()}; }

ara::core::Result<ByteView> Failed(ComErrc error, ReturnCode code = ReturnCode::kOk) {
    return ara::core::Result<ByteView>{ara::core::ErrorCode{error, static_cast<std::int32_t>(code)}};
}

bool IsField(const RemoteService& remote, std::uint16_t id) {
    if (remote.queues.empty()) {
        return false;
    }
    const auto& events = remote.queues.front()->Instance().Service().events;
    return std::any_of(events.begin(), events.end(),
                       [id](const EventDescription& event) { return event.id == id && event.is_field; });
}

}  // namespace

Handles Consumer::Found(const ServiceDescription& service, std::uint16_t instance) const {
    Handles handles;
    const auto end = remotes_.upper_bound({service.id, 0xFFFF});
    for (auto found = remotes_.lower_bound({service.id, 0}); found != end; ++found) {
        const auto& [key, remote] = *found;
        const bool is_meant = instance == kAnyInstance || instance == key.second;
        if (is_meant && remote.offer.has_value() && remote.offer->major_version == service.major_version) {
            handles.emplace_back(service, key.second);
        }
    }
    return handles;
}

void Consumer::Subscribe(const std::shared_ptr<EventQueue>& queue) {
    const auto key = KeyOf(queue->Instance());
    RemoteService& remote = remotes_[key];
    const auto& event = queue->Event();
    const bool is_first = remote.Groups().count(event.group) == 0;
    remote.queues.push_back(queue);
    queue->SetState(SubscriptionState::kSubscriptionPending);
    if (is_first && remote.offer.has_value()) {
        BeginSubscription(key, remote, queue->Instance().Service(), event.group);
    } else if (remote.acknowledged.count(event.group) > 0) {
        queue->SetState(SubscriptionState::kSubscribed);
        if (const auto latest = remote.latest.find(event.id); latest != remote.latest.end()) {
            queue->Push({latest->second.header, latest->second.payload});
        }
    }
}

void Consumer::Unsubscribe(const std::shared_ptr<EventQueue>& queue) {
    const auto key = KeyOf(queue->Instance());
    RemoteService& remote = remotes_[key];
    const auto found = std::find(remote.queues.begin(), remote.queues.end(), queue);
    if (found == remote.queues.end()) {
        return;
    }
    remote.queues.erase(found);
    const auto group = queue->Event().group;
    if (remote.Groups().count(group) == 0) {
        remote.begun.erase(group);
        remote.acknowledged.erase(group);
        for (const auto& event : queue->Instance().Service().events) {
            if (event.group == group) {
                remote.latest.erase(event.id);
            }
        }
        if (remote.offer.has_value()) {
            SendSubscription(key, remote, queue->Instance().Service(), group, 0);
        }
    }
}

bool Consumer::Call(const Handle& handle, std::uint16_t method, ByteView arguments, Answer answer) {
    RemoteService& remote = remotes_[KeyOf(handle)];
    if (!remote.offer.has_value()) {
        return false;
    }
    session_ = session_ == 0xFFFF ? std::uint16_t{1} : static_cast<std::uint16_t>(session_ + 1);
    const auto old = remote.calls.find(session_);
    if (old != remote.calls.end()) {  // 65,534 requests later, no answer will arrive
        runtime_.Unlocked([lost = std::move(old->second.answer)] { lost(Failed(ComErrc::kCommunicationLinkError)); });
    }
    remote.calls[session_] = {method, &handle.Service(), std::move(answer)};
    const Header header{handle.Service().id,
                        method,
                        static_cast<std::uint16_t>(runtime_.ServiceEndpoint().address),
                        session_,
                        kProtocolVersion,
                        handle.Service().major_version,
                        static_cast<std::uint8_t>(MessageType::kRequest),
                        ReturnCode::kOk};
    runtime_.Send(header, arguments, remote.offer->endpoint);
    return true;
}

void Consumer::TakeOffer(const Entry& entry, const Endpoint& from, bool is_multicast) {
    const InstanceKey key{entry.service, entry.instance};
    if (remotes_.size() >= kMostRemotes && remotes_.count(key) == 0) {
        return;
    }
    RemoteService& remote = remotes_[key];
    if (entry.time_to_live == 0) {
        if (remote.IsKnownFrom(from)) {
            Withdraw(key, remote);
        }
        return;
    }
    if (!entry.endpoint.has_value() || !entry.endpoint->IsLoopback()) {
        return;
    }
    const bool is_same = remote.IsOfferedBy(*entry.endpoint) && remote.IsKnownFrom(from) &&
                         remote.offer->major_version == entry.major_version;
    if (remote.offer.has_value() && !is_same) {
        Withdraw(key, remote);
    }
    if (is_same && remote.offer->expiry.has_value()) {
        runtime_.Later().Cancel(*remote.offer->expiry);
    }
    remote.offer = RemoteService::Offer{*entry.endpoint, from, entry.major_version, std::nullopt};
    if (entry.time_to_live != kForEver) {
        remote.offer->expiry = runtime_.Later().After(Milliseconds{1000.0 * entry.time_to_live}, [this, key] {
            remotes_[key].offer->expiry.reset();
            Withdraw(key, remotes_[key]);
        });
    }
    Renew(key, remote, is_multicast);
    runtime_.Sought().Compare(entry);
    if (!is_same) {
        runtime_.Sought().Changed(entry.service);
    }
}

void Consumer::TakeAcknowledgement(const Entry& entry, const Endpoint& from) {
    const auto found = remotes_.find({entry.service, entry.instance});
    if (found == remotes_.end() || !found->second.IsKnownFrom(from)) {
        return;
    }
    RemoteService& remote = found->second;
    const bool is_subscribed = entry.time_to_live > 0;
    if (is_subscribed) {
        remote.acknowledged.insert(entry.group);
    } else {
        remote.acknowledged.erase(entry.group);
    }
    for (const auto& queue : remote.queues) {
        if (queue->Event().group == entry.group) {
            queue->SetState(is_subscribed ? SubscriptionState::kSubscribed : SubscriptionState::kSubscriptionPending);
        }
    }
}

void Consumer::TakeEvent(const Message& message, const Endpoint& from) {
    RemoteService* const remote = OfferedBy(message.header.service, from);
    if (remote == nullptr || message.header.interface_version != remote->offer->major_version) {
        return;
    }
    for (const auto& queue : remote->queues) {
        if (queue->Event().id == message.header.method) {
            queue->Push(message);
        }
    }
    // Also of a field without a reader yet: with its group subscribed to, it is sent once.
    if (IsField(*remote, message.header.method)) {
        remote->latest[message.header.method] = {message.header, {message.payload.begin(), message.payload.end()}};
    }
}

void Consumer::TakeAnswer(const Message& message, const Endpoint& from) {
    const Header& header = message.header;
    RemoteService* const remote = OfferedBy(header.service, from);
    const bool is_mine = header.client == static_cast<std::uint16_t>(runtime_.ServiceEndpoint().address);
    if (remote == nullptr || !is_mine) {
        return;
    }
    const auto found = remote->calls.find(header.session);
    if (found == remote->calls.end() || found->second.method != header.method) {
        return;
    }
    Answer answer = std::move(found->second.answer);
    if (header.Is(MessageType::kError) || header.code != ReturnCode::kOk) {
        const auto error = ReadError(message, *found->second.service);
        remote->calls.erase(found);
        runtime_.Unlocked([answer = std::move(answer), code = header.code, error] {
            answer(error.has_value() ? ara::core::Result<ByteView>{*error}
                                     : Failed(ComErrc::kCommunicationStackError, code));
        });
        return;
    }
    remote->calls.erase(found);
    runtime_.Unlocked([answer = std::move(answer), payload = Bytes{message.payload.begin(), message.payload.end()}] {
        answer(ara::core::Result<ByteView>{ByteView{payload}});
    });
}

void Consumer::Lost(const Endpoint& peer) {
    for (auto& [key, remote] : remotes_) {
        if (remote.IsKnownFrom(peer)) {
            Withdraw(key, remote);
        }
    }
}

void Consumer::Clear() {
    for (auto& [key, remote] : remotes_) {
        Fail(remote);
    }
    remotes_.clear();
}

std::size_t Consumer::Missing() const {
    std::size_t missing = 0;
    for (const auto& [key, remote] : remotes_) {
        missing += static_cast<std::size_t>(
            std::count_if(remote.queues.begin(), remote.queues.end(),
                          [](const auto& queue) { return queue->State() != SubscriptionState::kSubscribed; }));
    }
    return missing;
}

RemoteService* Consumer::OfferedBy(std::uint16_t service, const Endpoint& endpoint) {
    const auto end = remotes_.upper_bound({service, 0xFFFF});
    const auto found = std::find_if(remotes_.lower_bound({service, 0}), end, [&endpoint](const auto& each) {
        return each.second.IsOfferedBy(endpoint);
    });
    return found == end ? nullptr : &found->second;
}

void Consumer::Renew(const InstanceKey& key, RemoteService& remote, bool is_multicast) {
    if (remote.queues.empty() || remote.renewal.has_value()) {
        return;
    }
    const auto& times = remote.queues.front()->Instance().Service().times;
    // Many answer what all have heard: not all at once.
    const auto delay = is_multicast ? runtime_.Between(times.response_delay_min, times.response_delay_max)
                                    : Milliseconds{0};
    remote.renewal = runtime_.Later().After(delay, [this, key] {
        remotes_[key].renewal.reset();
        SendSubscriptions(key, remotes_[key]);
    });
}

void Consumer::SendSubscriptions(const InstanceKey& key, RemoteService& remote) {
    if (remote.offer.has_value() && !remote.queues.empty()) {
        const auto& service = remote.queues.front()->Instance().Service();
        for (const auto group : remote.Groups()) {
            BeginSubscription(key, remote, service, group);
        }
    }
}

void Consumer::BeginSubscription(const InstanceKey& key, RemoteService& remote, const ServiceDescription& service,
                                 std::uint16_t group) {
    // The provider may still have a subscription of before it was lost; only a new one is sent the values of fields.
    if (remote.begun.insert(group).second) {
        SendSubscription(key, remote, service, group, 0);
    }
    SendSubscription(key, remote, service, group, service.times.subscribe_time_to_live);
}

void Consumer::SendSubscription(const InstanceKey& key, const RemoteService& remote,
                                const ServiceDescription& service, std::uint16_t group, std::uint32_t time_to_live) {
    Entry entry{EntryType::kSubscribe, key.first, key.second, service.major_version, time_to_live};
    entry.group = group;
    entry.endpoint = runtime_.ServiceEndpoint();
    runtime_.Discovery().Add(remote.offer->peer, entry);
    runtime_.Wake();
}

void Consumer::Withdraw(const InstanceKey& key, RemoteService& remote) {
    for (auto* const timer : {&remote.offer->expiry, &remote.renewal}) {
        if (timer->has_value()) {
            runtime_.Later().Cancel(**timer);
            timer->reset();
        }
    }
    remote.offer.reset();
    remote.begun.clear();
    remote.acknowledged.clear();
    remote.latest.clear();
    for (const auto& queue : remote.queues) {
        queue->SetState(SubscriptionState::kSubscriptionPending);
    }
    Fail(remote);
    runtime_.Sought().Changed(key.first);
}

void Consumer::Fail(RemoteService& remote) {
    for (auto& [session, call] : std::exchange(remote.calls, {})) {
        runtime_.Unlocked(
            [answer = std::move(call.answer)] { answer(Failed(ComErrc::kServiceNotAvailable)); });
    }
}

}  // namespace bench
