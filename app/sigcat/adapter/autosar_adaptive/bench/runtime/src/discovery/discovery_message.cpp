#include "discovery/discovery_message.h"

#include <algorithm>

#include "someip/big_endian.h"

namespace bench {
namespace {

constexpr std::uint8_t kReboot = 0x80;
constexpr std::uint8_t kUnicast = 0x40;
constexpr std::size_t kEntryLength = 16;
constexpr std::size_t kOptionLength = 9;  // of an endpoint, as it is counted
constexpr std::size_t kOptionHead = 3;    // length and type, which the length does not count
constexpr std::uint8_t kIpv4Endpoint = 0x04;
constexpr std::uint8_t kUdp = 0x11;

using Options = std::vector<ByteView>;

void AppendOption(Bytes& bytes, const Endpoint& endpoint) {
    Append(bytes, kOptionLength, 2);
    Append(bytes, kIpv4Endpoint, 1);
    Append(bytes, 0, 1);
    Append(bytes, endpoint.address, 4);
    Append(bytes, 0, 1);
    Append(bytes, kUdp, 1);
    Append(bytes, endpoint.port, 2);
}

void AppendEntry(Bytes& bytes, const Entry& entry, std::size_t option) {
    Append(bytes, static_cast<std::uint32_t>(entry.type), 1);
    Append(bytes, static_cast<std::uint32_t>(option), 1);
    Append(bytes, 0, 1);
    Append(bytes, entry.endpoint.has_value() ? 0x10 : 0, 1);
    Append(bytes, entry.service, 2);
    Append(bytes, entry.instance, 2);
    Append(bytes, entry.major_version, 1);
    Append(bytes, entry.time_to_live, 3);
    if (entry.IsOfGroup()) {
        Append(bytes, entry.counter, 2);
        Append(bytes, entry.group, 2);
    } else {
        Append(bytes, entry.minor_version, 4);
    }
}

std::optional<Options> ParseOptions(ByteView bytes) {
    Options options;
    while (!bytes.empty()) {
        if (bytes.size() < kOptionHead + 1) {
            return std::nullopt;
        }
        const std::size_t length = kOptionHead + NumberAt(bytes, 0, 2);
        if (length > bytes.size() || length <= kOptionHead) {
            return std::nullopt;
        }
        options.push_back(bytes.first(length));
        bytes = bytes.subspan(length);
    }
    return options;
}

std::optional<Endpoint> UdpEndpoint(ByteView option) {
    const bool is_one = option.size() == kOptionHead + kOptionLength && option[2] == kIpv4Endpoint && option[9] == kUdp;
    return is_one ? std::optional{Endpoint{NumberAt(option, 4, 4), ShortAt(option, 10)}} : std::nullopt;
}

// The endpoint among the options of two runs; false if they are not there.
bool FindEndpoint(ByteView entry, const Options& options, std::optional<Endpoint>& found) {
    const std::size_t both = entry[3];
    const std::size_t counts[] = {both >> 4, both & 0x0F};
    for (std::size_t run = 0; run < 2; ++run) {
        const std::size_t begin = entry[1 + run];
        if (counts[run] > 0 && begin + counts[run] > options.size()) {
            return false;
        }
        for (std::size_t n = 0; n < counts[run] && !found.has_value(); ++n) {
            found = UdpEndpoint(options[begin + n]);
        }
    }
    return true;
}

bool IsKnown(std::uint8_t type) {
    const auto known = {EntryType::kFind, EntryType::kOffer, EntryType::kSubscribe, EntryType::kSubscribeAck};
    return std::find(known.begin(), known.end(), static_cast<EntryType>(type)) != known.end();
}

std::optional<Entry> ParseEntry(ByteView bytes, const Options& options) {
    Entry entry{static_cast<EntryType>(bytes[0]), ShortAt(bytes, 4), ShortAt(bytes, 6), bytes[8],
                NumberAt(bytes, 9, 3)};
    if (entry.IsOfGroup()) {
        entry.counter = bytes[13] & 0x0FU;
        entry.group = ShortAt(bytes, 14);
    } else {
        entry.minor_version = NumberAt(bytes, 12, 4);
    }
    return FindEndpoint(bytes, options, entry.endpoint) ? std::optional{entry} : std::nullopt;
}

}  // namespace

Bytes Written(const DiscoveryMessage& message) {
    std::vector<Endpoint> endpoints;  // entries share an option
    Bytes entries;
    for (const Entry& entry : message.entries) {
        std::size_t option = 0;
        if (entry.endpoint.has_value()) {
            const auto found = std::find(endpoints.begin(), endpoints.end(), *entry.endpoint);
            option = static_cast<std::size_t>(found - endpoints.begin());
            if (found == endpoints.end()) {
                endpoints.push_back(*entry.endpoint);
            }
        }
        AppendEntry(entries, entry, option);
    }
    Bytes payload{static_cast<std::uint8_t>(kUnicast | (message.has_rebooted ? kReboot : 0)), 0, 0, 0};
    Append(payload, static_cast<std::uint32_t>(entries.size()), 4);
    payload.insert(payload.end(), entries.begin(), entries.end());
    Append(payload, static_cast<std::uint32_t>(endpoints.size() * (kOptionHead + kOptionLength)), 4);
    for (const Endpoint& endpoint : endpoints) {
        AppendOption(payload, endpoint);
    }
    return Written(Header{kDiscoveryService, kDiscoveryMethod, 0, message.session, kProtocolVersion, 1,
                          static_cast<std::uint8_t>(MessageType::kNotification), ReturnCode::kOk},
                   payload);
}

std::optional<DiscoveryMessage> ParseDiscovery(const Message& message) {
    const Header& header = message.header;
    const ByteView payload = message.payload;
    const bool is_one = header.service == kDiscoveryService && header.method == kDiscoveryMethod &&
                        header.interface_version == 1 && header.Is(MessageType::kNotification) && header.session != 0;
    if (!is_one || payload.size() < 12) {
        return std::nullopt;
    }
    const std::size_t entries_length = NumberAt(payload, 4, 4);
    if (entries_length % kEntryLength != 0 || entries_length > payload.size() - 12) {
        return std::nullopt;
    }
    const std::size_t options_length = NumberAt(payload, 8 + entries_length, 4);
    if (options_length > payload.size() - 12 - entries_length) {
        return std::nullopt;
    }
    const auto options = ParseOptions(payload.subspan(12 + entries_length, options_length));
    if (!options.has_value()) {
        return std::nullopt;
    }
    DiscoveryMessage parsed{(payload[0] & kReboot) != 0, header.session, {}};
    for (std::size_t at = 8; at < 8 + entries_length; at += kEntryLength) {
        const auto entry = ParseEntry(payload.subspan(at, kEntryLength), *options);
        if (entry.has_value() && IsKnown(payload[at])) {
            parsed.entries.push_back(*entry);
        }
    }
    return parsed;
}

}  // namespace bench
