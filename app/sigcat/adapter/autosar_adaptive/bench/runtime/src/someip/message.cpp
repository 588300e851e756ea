#include "someip/message.h"

#include "someip/big_endian.h"

namespace bench {
namespace {

constexpr std::size_t kCounted = 8;  // bytes of the header that the length counts

}  // namespace

Bytes Written(const Header& header, ByteView payload) {
    Bytes bytes;
    bytes.reserve(kHeaderLength + payload.size());
    Append(bytes, header.service, 2);
    Append(bytes, header.method, 2);
    Append(bytes, static_cast<std::uint32_t>(kCounted + payload.size()), 4);
    Append(bytes, header.client, 2);
    Append(bytes, header.session, 2);
    Append(bytes, header.protocol_version, 1);
    Append(bytes, header.interface_version, 1);
    Append(bytes, header.type, 1);
    Append(bytes, static_cast<std::uint32_t>(header.code), 1);
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    return bytes;
}

std::optional<Message> NextMessage(ByteView& rest) {
    if (rest.size() < kHeaderLength) {
        return std::nullopt;
    }
    const std::size_t length = NumberAt(rest, 4, 4);
    if (length < kCounted || length > rest.size() - kCounted) {
        return std::nullopt;
    }
    const Header header{ShortAt(rest, 0),  ShortAt(rest, 2), ShortAt(rest, 8), ShortAt(rest, 10),
                        rest[12],          rest[13],         rest[14],         static_cast<ReturnCode>(rest[15])};
    const ByteView payload = rest.subspan(kHeaderLength, length - kCounted);
    rest = rest.subspan(kCounted + length);
    return Message{header, payload};
}

}  // namespace bench
