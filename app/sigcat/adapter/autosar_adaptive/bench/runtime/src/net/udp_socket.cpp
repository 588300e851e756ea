#include "net/udp_socket.h"

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bench {
namespace {

constexpr int kReceiveBuffer = 4 << 20;  // bytes; the system gives what it allows

sockaddr_in Address(const Endpoint& endpoint) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(endpoint.address);
    address.sin_port = htons(endpoint.port);
    return address;
}

ip_mreqn Membership(std::uint32_t group, std::uint32_t interface_address) {
    ip_mreqn membership{};
    membership.imr_multiaddr.s_addr = htonl(group);
    membership.imr_address.s_addr = htonl(interface_address);
    membership.imr_ifindex = static_cast<int>(if_nametoindex("lo"));
    return membership;
}

template <typename Value>
bool Sets(int descriptor, int level, int option, const Value& value) {
    return setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

bool Binds(int descriptor, const Endpoint& endpoint) {
    const sockaddr_in address = Address(endpoint);
    return bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

}  // namespace

std::optional<UdpSocket> UdpSocket::Bound(const Endpoint& endpoint, Port port) {
    UdpSocket made{socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    const bool is_ready = made.descriptor_ >= 0 && endpoint.IsLoopback() &&
                          (port == Port::kOwn || Sets(made.descriptor_, SOL_SOCKET, SO_REUSEADDR, 1)) &&
                          Binds(made.descriptor_, endpoint);
    if (!is_ready) {
        return std::nullopt;
    }
    Sets(made.descriptor_, SOL_SOCKET, SO_RCVBUF, kReceiveBuffer);
    return made;
}

std::optional<UdpSocket> UdpSocket::OfGroup(const Endpoint& group, std::uint32_t interface_address) {
    UdpSocket made{socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    // Both, as the system wants all who share a port to share it in the same way, and others have either.
    const bool joins = made.descriptor_ >= 0 && Sets(made.descriptor_, SOL_SOCKET, SO_REUSEADDR, 1) &&
                       Sets(made.descriptor_, SOL_SOCKET, SO_REUSEPORT, 1) &&
                       Binds(made.descriptor_, group) &&
                       Sets(made.descriptor_, IPPROTO_IP, IP_ADD_MEMBERSHIP,
                            Membership(group.address, interface_address));
    if (!joins) {
        return std::nullopt;
    }
    return made;
}

UdpSocket::~UdpSocket() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

bool UdpSocket::SendGroupsFrom(std::uint32_t interface_address) const noexcept {
    return Sets(descriptor_, IPPROTO_IP, IP_MULTICAST_IF, Membership(0, interface_address)) &&
           Sets(descriptor_, IPPROTO_IP, IP_MULTICAST_LOOP, 1);
}

void UdpSocket::Send(const Bytes& datagram, const Endpoint& to) const noexcept {
    const sockaddr_in address = Address(to);
    // What cannot be sent is lost, as on any network.
    static_cast<void>(sendto(descriptor_, datagram.data(), datagram.size(), 0,
                             reinterpret_cast<const sockaddr*>(&address), sizeof address));
}

std::optional<std::size_t> UdpSocket::Receive(Bytes& buffer, Endpoint& from) const noexcept {
    sockaddr_in address{};
    socklen_t length = sizeof address;
    const auto received = recvfrom(descriptor_, buffer.data(), buffer.size(), 0,
                                   reinterpret_cast<sockaddr*>(&address), &length);
    if (received < 0) {
        return std::nullopt;
    }
    from = {ntohl(address.sin_addr.s_addr), ntohs(address.sin_port)};
    return static_cast<std::size_t>(received);
}

}  // namespace bench
