// Records what components send, each value at the time at which it was sent, if that is known.

#ifndef PLAYER_HEAR_H
#define PLAYER_HEAR_H

#include <cstddef>
#include <memory>
#include <string>

#include "application/communication.h"
#include "ara/log/logger.h"
#include "player/cell.h"
#include "player/ports.h"

namespace player {

constexpr std::size_t kMostSamples = 64;

/// What was heard before, and the text that was recorded last.
struct Heard final {
    bool is_first{true};
    std::string text;
};

/// Subscribes to an event or a field. `is_repeated`: a state is sent again and again, and recorded when it changes.
template <typename Event>
void Hear(ara::log::Logger& logger, Event& event, const char* name, Recorder& recorder, bool is_repeated = false) {
    const auto set = event.SetReceiveHandler([&event, name, &recorder, is_repeated, heard = std::make_shared<Heard>()] {
        static_cast<void>(event.GetNewSamples([name, &recorder, is_repeated, &heard](const auto& sample) {
            if (!application::IsAccepted(sample.GetProfileCheckStatus(), false, heard->is_first)) {
                return;
            }
            heard->is_first = false;
            const std::string text = Text(*sample);
            if ((!is_repeated || text != heard->text) && recorder.Take(name, text, sample.BenchSentAt())) {
                heard->text = text;
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
