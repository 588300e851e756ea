// What has come of an event and was not read yet, and who wants to know of it.
#ifndef BENCH_SERVICES_EVENT_QUEUE_H_
#define BENCH_SERVICES_EVENT_QUEUE_H_

#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>

#include "ara/com/types.h"
#include "bench/event_receiver.h"
#include "bench/handle.h"
#include "e2e/protection.h"
#include "services/dispatcher.h"

namespace bench {

class EventQueue : public std::enable_shared_from_this<EventQueue> {
public:
    EventQueue(const Handle& handle, const EventDescription& event, Dispatcher& dispatcher)
        : handle_{handle}, event_{event}, dispatcher_{dispatcher}, checker_{event.protection} {}

    const Handle& Instance() const noexcept { return handle_; }
    const EventDescription& Event() const noexcept { return event_; }

    // From now on, this many samples are kept, and as many can be held at once.
    void Open(std::size_t count);
    void Close();
    std::size_t Count() const;

    void Push(const Message& message);
    std::optional<Received> Pop();
    std::size_t Free() const noexcept;
    void TellMalformed();

    ara::com::SubscriptionState State() const;
    void SetState(ara::com::SubscriptionState state);

    void SetReceiveHandler(ara::com::EventReceiveHandler handler);
    void SetStateHandler(ara::com::SubscriptionStateChangeHandler handler);

private:
    using Places = std::atomic<std::size_t>;

    void PostReceived();

    const Handle handle_;
    const EventDescription& event_;
    Dispatcher& dispatcher_;

    mutable std::mutex mutex_;
    struct Kept {
        Bytes values;
        ara::com::e2e::ProfileCheckStatus status;
        std::optional<std::uint64_t> sent_at;
    };
    Checker checker_;
    std::deque<Kept> kept_;
    std::size_t count_ = 0;
    std::shared_ptr<Places> free_ = std::make_shared<Places>(0);
    ara::com::SubscriptionState state_ = ara::com::SubscriptionState::kNotSubscribed;
    std::shared_ptr<ara::com::EventReceiveHandler> receive_handler_;
    std::shared_ptr<ara::com::SubscriptionStateChangeHandler> state_handler_;
    bool is_posted_ = false;
    bool was_malformed_ = false;
};

}  // namespace bench

#endif  // BENCH_SERVICES_EVENT_QUEUE_H_
