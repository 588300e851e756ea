// Events and fields, received and sent.

#ifndef APPLICATION_COMMUNICATION_H
#define APPLICATION_COMMUNICATION_H

#include <cstddef>
#include <memory>
#include <utility>

#include "application/e2e.h"
#include "application/values.h"
#include "ara/log/logger.h"

namespace application {

/// An event or a field, as a component receives it.
struct Subscription final {
    const char* name;
    std::size_t capacity;
    bool is_protected;  // end to end, as the model says
};

/// Whether the platform has checked a sample of a protected event at all.
constexpr bool IsChecked(ara::com::e2e::ProfileCheckStatus status) {
    using Status = ara::com::e2e::ProfileCheckStatus;
    return status != Status::kNotAvailable && status != Status::kNoNewData && status != Status::kCheckDisabled;
}

/// Whether a sample is taken. What is protected must be checked: a platform without the mapping would leave it
/// unprotected. The first sample has none before it: of a sender that already runs, it is out of sequence.
constexpr bool IsAccepted(ara::com::e2e::ProfileCheckStatus status, bool is_protected, bool is_first) {
    using Status = ara::com::e2e::ProfileCheckStatus;
    if (!IsChecked(status)) {
        return !is_protected;
    }
    return status == Status::kOk || (status == Status::kWrongSequence && is_first);
}

/// What a subscription remembers from one sample to the next.
struct Received final {
    bool is_first{true};
    bool has_logged_missing_check{false};
};

/// Subscribes to an event or a field; each of its values goes to `take`, in a thread of the platform. For one that is
/// not accepted, `reject` is called.
template <typename Event, typename Take, typename Reject>
void Receive(ara::log::Logger& logger, Event& event, const Subscription& subscription, Take take, Reject reject) {
    const auto set = event.SetReceiveHandler([&logger, &event, subscription, take, reject,
                                              received = std::make_shared<Received>()] {
        static_cast<void>(event.GetNewSamples([&](const auto& sample) {
            const auto status = sample.GetProfileCheckStatus();
            if (IsAccepted(status, subscription.is_protected, received->is_first)) {
                received->is_first = false;
                take(*sample);
                return;
            }
            if (!IsChecked(status) && !received->has_logged_missing_check) {
                received->has_logged_missing_check = true;
                logger.LogError() << subscription.name << " must be protected end to end, but the platform does not check it";
            }
            reject();
        }));
    });
    const auto subscribed = event.Subscribe(subscription.capacity);
    if (!set.HasValue() || !subscribed.HasValue()) {
        logger.LogError() << subscription.name << " cannot be subscribed to";
    }
}

template <typename Event, typename Take>
void Receive(ara::log::Logger& logger, Event& event, const Subscription& subscription, Take take) {
    Receive(logger, event, subscription, take, [] {});
}

/// Sends a value of the core as an event.
template <typename Event, typename Value>
void Send(ara::log::Logger& logger, Event& event, const Value& value) {
    auto allocated = event.Allocate();
    if (!allocated.HasValue()) {
        logger.LogError() << "No memory to send an event: " << allocated.Error().Message();
        return;
    }
    auto sample = std::move(allocated).Value();
    Assign(value, *sample);
    const auto sent = event.Send(std::move(sample));
    if (!sent.HasValue()) {
        logger.LogError() << "An event cannot be sent: " << sent.Error().Message();
    }
}

/// Updates a field with a value of the core.
template <typename FieldType, typename Field, typename Value>
void Update(ara::log::Logger& logger, Field& field, const Value& value) {
    FieldType converted{};
    Assign(value, converted);
    const auto updated = field.Update(converted);
    if (!updated.HasValue()) {
        logger.LogError() << "A field cannot be updated: " << updated.Error().Message();
    }
}

}  // namespace application

#endif  // APPLICATION_COMMUNICATION_H
