// The sockets of the process, on its own address.
#ifndef BENCH_SERVICES_NETWORK_H_
#define BENCH_SERVICES_NETWORK_H_

#include <memory>

#include "net/udp_socket.h"

namespace bench {

constexpr std::uint16_t kServicePort = 30509;

struct Network {
    std::uint32_t address;
    UdpSocket discovery;
    UdpSocket group;  // receives the discovery that is sent to all
    UdpSocket services;

    Endpoint ServiceEndpoint() const noexcept { return {address, kServicePort}; }
};

// On the address that SIGCAT_BENCH_ADDRESS names, or else on the first free one from 127.0.0.2 on. None if it is in use.
std::unique_ptr<Network> OpenNetwork();

}  // namespace bench

#endif  // BENCH_SERVICES_NETWORK_H_
