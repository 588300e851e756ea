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

/// Whether end-to-end protection has nothing against a sample. What is not protected is not checked. The first whole one
/// has none before it: of a sender that already runs, the platform calls it out of sequence.
inline bool IsAccepted(ara::com::e2e::ProfileCheckStatus status, bool is_first) {
    using Status = ara::com::e2e::ProfileCheckStatus;
    return status != Status::kError && status != Status::kRepeated && (is_first || status != Status::kWrongSequence);
}

/// Subscribes to an event or a field; each of its values goes to `take`, in a thread of the platform. For one that
/// end-to-end protection rejects, `reject` is called.
template <typename Event, typename Take, typename Reject>
void Receive(ara::log::Logger& logger, Event& event, std::size_t capacity, Take take, Reject reject) {
    const auto set = event.SetReceiveHandler([&event, take, reject, is_first = std::make_shared<bool>(true)] {
        static_cast<void>(event.GetNewSamples([&take, &reject, &is_first](const auto& sample) {
            if (IsAccepted(sample.GetProfileCheckStatus(), *is_first)) {
                *is_first = false;
                take(*sample);
            } else {
                reject();
            }
        }));
    });
    const auto subscribed = event.Subscribe(capacity);
    if (!set.HasValue() || !subscribed.HasValue()) {
        logger.LogError() << "An event cannot be subscribed to";
    }
}

template <typename Event, typename Take>
void Receive(ara::log::Logger& logger, Event& event, std::size_t capacity, Take take) {
    Receive(logger, event, capacity, take, [] {});
}

/// Sends a value of the core as an event.
template <typename Event, typename Value>
void Send(ara::log::Logger& logger, Event& event, const Value& value) {
    auto allocated = event.Allocate();
    if (!allocated.HasValue()) {
        logger.LogError() << "There is no room to send an event: " << allocated.Error().Message();
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
