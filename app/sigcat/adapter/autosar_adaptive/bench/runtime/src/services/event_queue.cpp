#include "services/event_queue.h"

#include <cstdio>
#include <utility>

namespace bench {

void EventQueue::Open(std::size_t count) {
    std::lock_guard<std::mutex> lock{mutex_};
    kept_.clear();
    checker_ = Checker{event_.protection};
    count_ = count;
    // Samples of a former subscription give their places back to that one.
    free_ = std::make_shared<Places>(count);
}

void EventQueue::Close() {
    Open(0);
    SetState(ara::com::SubscriptionState::kNotSubscribed);
}

std::size_t EventQueue::Count() const {
    std::lock_guard<std::mutex> lock{mutex_};
    return count_;
}

void EventQueue::Push(const Message& message) {
    std::lock_guard<std::mutex> lock{mutex_};
    if (count_ == 0) {
        return;
    }
    const auto status = checker_.Check(message.header, message.payload);
    if (kept_.size() == count_) {
        kept_.pop_front();  // what is newest counts
    }
    const ByteView values = Values(event_.protection, message.payload);
    kept_.push_back({{values.begin(), values.end()}, status, message.sent_at});
    if (receive_handler_ != nullptr && !is_posted_) {
        PostReceived();
    }
}

std::optional<Received> EventQueue::Pop() {
    std::lock_guard<std::mutex> lock{mutex_};
    if (kept_.empty() || *free_ == 0) {
        return std::nullopt;
    }
    --*free_;
    auto& [values, status, sent_at] = kept_.front();
    Received received{std::move(values), std::shared_ptr<void>{nullptr, [free = free_](void*) { ++*free; }}, status,
                      sent_at};
    kept_.pop_front();
    return received;
}

std::size_t EventQueue::Free() const noexcept {
    std::lock_guard<std::mutex> lock{mutex_};
    return *free_;
}

void EventQueue::TellMalformed() {
    std::lock_guard<std::mutex> lock{mutex_};
    if (!std::exchange(was_malformed_, true)) {  // once: it will hardly be the only one
        std::fprintf(stderr, "bench: a sample of %s cannot be read: its sender has other datatypes.\n",
                     event_.name.data());
    }
}

ara::com::SubscriptionState EventQueue::State() const {
    std::lock_guard<std::mutex> lock{mutex_};
    return state_;
}

void EventQueue::SetState(ara::com::SubscriptionState state) {
    std::lock_guard<std::mutex> lock{mutex_};
    if (state_ == state) {
        return;
    }
    state_ = state;
    if (state_handler_ != nullptr) {
        dispatcher_.Post(&state_handler_, [handler = state_handler_, state] { (*handler)(state); });
    }
}

void EventQueue::SetReceiveHandler(ara::com::EventReceiveHandler handler) {
    const bool ends = !handler;
    {
        std::lock_guard<std::mutex> lock{mutex_};
        is_posted_ = false;
        receive_handler_ = !ends ? std::make_shared<ara::com::EventReceiveHandler>(std::move(handler)) : nullptr;
        if (receive_handler_ != nullptr && !kept_.empty()) {
            PostReceived();
        }
    }
    if (ends) {
        dispatcher_.Retire(&receive_handler_);
    }
}

void EventQueue::SetStateHandler(ara::com::SubscriptionStateChangeHandler handler) {
    const bool ends = !handler;
    {
        std::lock_guard<std::mutex> lock{mutex_};
        state_handler_ =
            !ends ? std::make_shared<ara::com::SubscriptionStateChangeHandler>(std::move(handler)) : nullptr;
    }
    if (ends) {
        dispatcher_.Retire(&state_handler_);
    }
}

void EventQueue::PostReceived() {
    is_posted_ = true;
    dispatcher_.Post(&receive_handler_, [self = shared_from_this()] {
        std::shared_ptr<ara::com::EventReceiveHandler> handler;
        {
            std::lock_guard<std::mutex> lock{self->mutex_};
            self->is_posted_ = false;
            handler = self->receive_handler_;
        }
        if (handler != nullptr) {
            (*handler)();
        }
    });
}

}  // namespace bench
