#include "someip/stamp.h"

#include "someip/big_endian.h"

namespace bench {
namespace {

constexpr std::uint16_t kStampService = 0xFFFE;  // of no service: AUTOSAR keeps it for what is not SOME/IP
constexpr std::uint16_t kStampEvent = 0x8001;
constexpr std::size_t kStampLength = 8;

}  // namespace

Bytes WrittenStamp(std::uint64_t time) {
    Bytes payload;
    Append(payload, static_cast<std::uint32_t>(time >> 32U), 4);
    Append(payload, static_cast<std::uint32_t>(time), 4);
    const auto type = static_cast<std::uint8_t>(MessageType::kNotification);
    return Written({kStampService, kStampEvent, 0, 0, kProtocolVersion, 0, type, ReturnCode::kOk}, payload);
}

std::optional<std::uint64_t> StampOf(const Message& message) {
    const bool is_stamp = message.header.service == kStampService && message.header.method == kStampEvent;
    if (!is_stamp || message.payload.size() != kStampLength) {
        return std::nullopt;
    }
    return (std::uint64_t{NumberAt(message.payload, 0, 4)} << 32U) | NumberAt(message.payload, 4, 4);
}

}  // namespace bench
