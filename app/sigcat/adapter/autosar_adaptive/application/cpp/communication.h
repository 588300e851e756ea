// Events and fields, received and sent.

#ifndef APPLICATION_COMMUNICATION_H
#define APPLICATION_COMMUNICATION_H

#include <cstddef>
#include <utility>

#include "application/values.h"
#include "ara/log/logger.h"

namespace application {

/// Subscribes to an event or a field; each of its values goes to `take`, in a thread of the platform.
template <typename Event, typename Take>
void Receive(ara::log::Logger& logger, Event& event, std::size_t capacity, Take take) {
    const auto set = event.SetReceiveHandler([&event, take] {
        static_cast<void>(event.GetNewSamples([&take](const auto& sample) { take(*sample); }));
    });
    const auto subscribed = event.Subscribe(capacity);
    if (!set.HasValue() || !subscribed.HasValue()) {
        logger.LogError() << "An event cannot be subscribed to";
    }
}

/// Sends a value of the core as an event.
template <typename Event, typename Value>
void Send(ara::log::Logger& logger, Event& event, const Value& value) {
    auto sample = event.Allocate();
    if (!sample.HasValue()) {
        logger.LogError() << "There is no room to send an event: " << sample.Error().Message();
        return;
    }
    Assign(value, *sample.Value());
    const auto sent = event.Send(std::move(sample).Value());
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
