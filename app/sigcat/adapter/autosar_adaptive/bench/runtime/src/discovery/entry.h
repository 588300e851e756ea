// An entry of service discovery, with the endpoint that its options name (PRS_SOMEIPServiceDiscovery, section 4.1).
#ifndef BENCH_DISCOVERY_ENTRY_H_
#define BENCH_DISCOVERY_ENTRY_H_

#include <cstdint>
#include <optional>

#include "net/endpoint.h"

namespace bench {

constexpr std::uint16_t kAnyInstance = 0xFFFF;
constexpr std::uint8_t kAnyMajorVersion = 0xFF;
constexpr std::uint32_t kAnyMinorVersion = 0xFFFFFFFF;
constexpr std::uint32_t kForEver = 0xFFFFFF;  // a time to live

enum class EntryType : std::uint8_t { kFind = 0x00, kOffer = 0x01, kSubscribe = 0x06, kSubscribeAck = 0x07 };

struct Entry {
    EntryType type;
    std::uint16_t service;
    std::uint16_t instance;
    std::uint8_t major_version;
    std::uint32_t time_to_live;      // in s; 0 ends what a former entry began
    std::uint32_t minor_version = 0;  // of a search or an offer
    std::uint16_t group = 0;          // of a subscription
    std::uint8_t counter = 0;         // of a subscription: several of one client differ in it
    std::optional<Endpoint> endpoint{};

    bool IsOfGroup() const noexcept { return type == EntryType::kSubscribe || type == EntryType::kSubscribeAck; }
};

}  // namespace bench

#endif  // BENCH_DISCOVERY_ENTRY_H_
