// What components send is recorded, each value at the time at which it was sent, if that is told.

#ifndef PLAYER_HEAR_H
#define PLAYER_HEAR_H

#include <cstddef>
#include <memory>

#include "application/communication.h"
#include "ara/log/logger.h"
#include "player/cell.h"
#include "player/ports.h"

namespace player {

constexpr std::size_t kMostSamples = 64;

/// Subscribes to an event or a field.
template <typename Event>
void Hear(ara::log::Logger& logger, Event& event, const char* name, Recorder& recorder) {
    const auto set = event.SetReceiveHandler([&event, name, &recorder, is_first = std::make_shared<bool>(true)] {
        static_cast<void>(event.GetNewSamples([name, &recorder, &is_first](const auto& sample) {
            if (application::IsAccepted(sample.GetProfileCheckStatus(), false, *is_first)) {
                *is_first = false;
                recorder.Take(name, Text(*sample), sample.BenchSentAt());
            }
        }));
    });
    const auto subscribed = event.Subscribe(kMostSamples);
    if (!set.HasValue() || !subscribed.HasValue()) {
        logger.LogError() << name << " cannot be subscribed to";
    }
}

}  // namespace player

#endif  // PLAYER_HEAR_H
