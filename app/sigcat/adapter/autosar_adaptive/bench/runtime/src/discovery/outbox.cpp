#include "discovery/outbox.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "discovery/discovery_message.h"

namespace bench {

void Outbox::Flush(const UdpSocket& socket) {
    for (const auto& [to, entries] : std::exchange(entries_, {})) {
        auto& session = sessions_[to];
        for (std::size_t at = 0; at < entries.size(); at += kMostEntries) {
            const auto begin = entries.begin() + static_cast<std::ptrdiff_t>(at);
            const auto count = std::min(kMostEntries, entries.size() - at);
            const std::uint16_t number = session.Next();
            const std::vector<Entry> part{begin, begin + static_cast<std::ptrdiff_t>(count)};
            socket.Send(Written(DiscoveryMessage{!session.HasWrapped(), number, part}), to);
        }
    }
    for (const auto& action : std::exchange(afterwards_, {})) {
        action();
    }
}

}  // namespace bench
