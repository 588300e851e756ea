#include "services/network.h"

#include <arpa/inet.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "ara/log/logger.h"
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

ara::log::Logger& Logger() { return ara::log::CreateLogger("COM", "Communication"); }

std::unique_ptr<Network> OpenNamed(const char* named) {
    in_addr parsed{};
    if (inet_pton(AF_INET, named, &parsed) != 1 || !Endpoint{ntohl(parsed.s_addr), kServicePort}.IsLoopback()) {
        Logger().LogError() << kVariable << " must be a loopback address such as 127.0.0.2, not " << named;
        return nullptr;
    }
    errno = 0;
    auto network = OpenOn(ntohl(parsed.s_addr));
    if (network == nullptr) {
        Logger().LogError() << "The address " << named << " of " << kVariable << " cannot be used: " << std::strerror(errno);
    }
    return network;
}

}  // namespace

std::unique_ptr<Network> OpenNetwork() {
    if (const char* const named = std::getenv(kVariable); named != nullptr) {
        return OpenNamed(named);
    }
    for (std::uint32_t address = kFirst; address <= kLast; ++address) {
        if (auto network = OpenOn(address); network != nullptr) {
            return network;
        }
    }
    Logger().LogError() << "All addresses from 127.0.0.2 to 127.0.0.254 are in use";
    return nullptr;
}

}  // namespace bench
