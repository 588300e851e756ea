// The receiving side of an event, whatever its type.
#ifndef BENCH_EVENT_RECEIVER_H_
#define BENCH_EVENT_RECEIVER_H_

#include <memory>
#include <optional>

#include "ara/com/types.h"
#include "bench/codec.h"
#include "bench/proxy_connection.h"

namespace bench {

class EventQueue;

// A received message that is not read yet, and the place of its sample.
struct Received {
    Bytes payload;
    std::shared_ptr<void> place;  // given back when it is released
    ara::com::e2e::ProfileCheckStatus status = ara::com::e2e::ProfileCheckStatus::kCheckDisabled;
    std::optional<std::uint64_t> sent_at{};  // if its sender tells it
};

class EventReceiver {
public:
    EventReceiver(const std::shared_ptr<ProxyConnection>& connection, const EventDescription& event);
    EventReceiver(EventReceiver&&) noexcept = default;
    EventReceiver& operator=(EventReceiver&& other) noexcept;
    ~EventReceiver();

    ara::core::Result<void> Subscribe(std::size_t maxSampleCount);
    void Unsubscribe();
    ara::com::SubscriptionState GetSubscriptionState() const;
    ara::core::Result<void> SetSubscriptionStateChangeHandler(ara::com::SubscriptionStateChangeHandler handler);
    // No handler that was unset runs when this has returned, unless it is the handler that calls it.
    void UnsetSubscriptionStateChangeHandler();
    ara::core::Result<void> SetReceiveHandler(ara::com::EventReceiveHandler handler);
    ara::core::Result<void> UnsetReceiveHandler();
    std::size_t GetFreeSampleCount() const noexcept;

protected:
    std::optional<Received> Next();
    // Of a message that could not be read: its sender has other types.
    void TellMalformed() const;

    std::shared_ptr<ProxyConnection> connection_;

private:
    std::shared_ptr<EventQueue> queue_;
};

}  // namespace bench

#endif  // BENCH_EVENT_RECEIVER_H_
