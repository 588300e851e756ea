// A message of SOME/IP (PRS_SOMEIPProtocol, section 4.1).
#ifndef BENCH_SOMEIP_MESSAGE_H_
#define BENCH_SOMEIP_MESSAGE_H_

#include <cstdint>
#include <optional>

#include "bench/codec.h"

namespace bench {

constexpr std::size_t kHeaderLength = 16;
constexpr std::uint8_t kProtocolVersion = 1;

enum class MessageType : std::uint8_t {
    kRequest = 0x00,
    kRequestNoReturn = 0x01,
    kNotification = 0x02,
    kResponse = 0x80,
    kError = 0x81,
};
constexpr std::uint8_t kSegment = 0x20;  // added to the type of a message in segments

enum class ReturnCode : std::uint8_t {
    kOk = 0x00,
    kNotOk = 0x01,
    kUnknownService = 0x02,
    kUnknownMethod = 0x03,
    kNotReady = 0x04,
    kWrongProtocolVersion = 0x07,
    kWrongInterfaceVersion = 0x08,
    kMalformedMessage = 0x09,
};

struct Header {
    std::uint16_t service;
    std::uint16_t method;  // or id of the event
    std::uint16_t client;
    std::uint16_t session;
    std::uint8_t protocol_version;
    std::uint8_t interface_version;
    std::uint8_t type;
    ReturnCode code;

    bool Is(MessageType wanted) const noexcept { return type == static_cast<std::uint8_t>(wanted); }
};

struct Message {
    Header header;
    ByteView payload;
    std::optional<std::uint64_t> sent_at{};  // an event whose sender tells it
};

Bytes Written(const Header& header, ByteView payload);

// The next message of a datagram, which may have several; none if the rest is not a message.
std::optional<Message> NextMessage(ByteView& rest);

}  // namespace bench

#endif  // BENCH_SOMEIP_MESSAGE_H_
