#include "services/network.h"

#include <arpa/inet.h>

#include <cstdlib>
#include <utility>

#include "discovery/discovery_message.h"

namespace bench {
namespace {

constexpr const char* kVariable = "SIGCAT_BENCH_ADDRESS";
constexpr std::uint32_t kFirst = 0x7F000002;
constexpr std::uint32_t kLast = 0x7F0000FE;

std::unique_ptr<Network> OpenOn(std::uint32_t address) {
    auto services = UdpSocket::Bound({address, kServicePort}, UdpSocket::Port::kOwn);
    if (!services.has_value()) {
        return nullptr;  // another process has the address
    }
    // Shared: other implementations receive the group on all addresses of this port.
    auto discovery = UdpSocket::Bound({address, kDiscoveryGroup.port}, UdpSocket::Port::kShared);
    auto group = UdpSocket::OfGroup(kDiscoveryGroup, address);
    if (!discovery.has_value() || !discovery->SendGroupsFrom(address) || !group.has_value()) {
        return nullptr;
    }
    return std::make_unique<Network>(Network{address, std::move(*discovery), std::move(*group), std::move(*services)});
}

}  // namespace

std::unique_ptr<Network> OpenNetwork() {
    if (const char* const named = std::getenv(kVariable); named != nullptr) {
        in_addr parsed{};
        return inet_pton(AF_INET, named, &parsed) == 1 ? OpenOn(ntohl(parsed.s_addr)) : nullptr;
    }
    for (std::uint32_t address = kFirst; address <= kLast; ++address) {
        if (auto network = OpenOn(address); network != nullptr) {
            return network;
        }
    }
    return nullptr;
}

}  // namespace bench
