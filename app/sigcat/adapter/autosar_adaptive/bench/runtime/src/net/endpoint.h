// An address of IPv4 and a port.
#ifndef BENCH_NET_ENDPOINT_H_
#define BENCH_NET_ENDPOINT_H_

#include <cstdint>
#include <tuple>

namespace bench {

struct Endpoint {
    std::uint32_t address;  // 127.0.0.1 is 0x7F000001
    std::uint16_t port;

    bool IsLoopback() const noexcept { return address >> 24 == 127; }
};

inline bool operator==(const Endpoint& left, const Endpoint& right) noexcept {
    return left.address == right.address && left.port == right.port;
}
inline bool operator!=(const Endpoint& left, const Endpoint& right) noexcept { return !(left == right); }
inline bool operator<(const Endpoint& left, const Endpoint& right) noexcept {
    return std::tie(left.address, left.port) < std::tie(right.address, right.port);
}

}  // namespace bench

#endif  // BENCH_NET_ENDPOINT_H_
