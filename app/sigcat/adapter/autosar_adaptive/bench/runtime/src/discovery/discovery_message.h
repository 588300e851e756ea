// Entries to bytes and back.
#ifndef BENCH_DISCOVERY_DISCOVERY_MESSAGE_H_
#define BENCH_DISCOVERY_DISCOVERY_MESSAGE_H_

#include <optional>
#include <vector>

#include "discovery/entry.h"
#include "someip/message.h"

namespace bench {

constexpr std::uint16_t kDiscoveryService = 0xFFFF;
constexpr std::uint16_t kDiscoveryMethod = 0x8100;
constexpr Endpoint kDiscoveryGroup{0xE0F4E0F5, 30490};  // 224.244.224.245
constexpr std::size_t kMostEntries = 40;                // of one datagram, with an option each

struct DiscoveryMessage {
    bool has_rebooted;  // since its sender last counted from the beginning
    std::uint16_t session;
    std::vector<Entry> entries;
};

Bytes Written(const DiscoveryMessage& message);

// None if any of it is wrong: who sends that is not understood at all.
std::optional<DiscoveryMessage> ParseDiscovery(const Message& message);

}  // namespace bench

#endif  // BENCH_DISCOVERY_DISCOVERY_MESSAGE_H_
