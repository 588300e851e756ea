// Messages that are longer than a datagram, in segments (PRS_SOMEIPProtocol, SOME/IP-TP).
#ifndef BENCH_SOMEIP_SEGMENTS_H_
#define BENCH_SOMEIP_SEGMENTS_H_

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "net/endpoint.h"
#include "someip/message.h"

namespace bench {

constexpr std::size_t kLongestPayload = 1400;  // of a datagram over UDP

// The datagrams of a message: one, or as many segments as it takes.
std::vector<Bytes> Datagrams(const Header& header, ByteView payload);

// Puts segments together. A message that begins again before it is complete replaces the earlier part.
class Reassembly {
public:
    // The whole payload, when the last segment of it comes.
    std::optional<Bytes> Add(const Message& segment, const Endpoint& from);

private:
    using Key = std::tuple<Endpoint, std::uint16_t, std::uint16_t, std::uint16_t>;
    struct Begun {
        std::uint16_t session;
        Bytes payload;
    };

    std::map<Key, Begun> begun_;
};

}  // namespace bench

#endif  // BENCH_SOMEIP_SEGMENTS_H_
