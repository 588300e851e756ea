// A socket of UDP on the loopback interface, and on no other.
#ifndef BENCH_NET_UDP_SOCKET_H_
#define BENCH_NET_UDP_SOCKET_H_

#include <optional>

#include "bench/codec.h"
#include "net/endpoint.h"

namespace bench {

class UdpSocket {
public:
    // Whether the port is of this socket alone on its address, or others may receive on all addresses.
    enum class Port { kOwn, kShared };

    // None if the endpoint is in use; a shared port is not in use for others that share it.
    static std::optional<UdpSocket> Bound(const Endpoint& endpoint, Port port);
    // Receives what is sent to a group; several processes share it.
    static std::optional<UdpSocket> OfGroup(const Endpoint& group, std::uint32_t interface_address);

    UdpSocket(UdpSocket&& other) noexcept : descriptor_{other.descriptor_} { other.descriptor_ = -1; }
    UdpSocket& operator=(UdpSocket&&) = delete;
    ~UdpSocket();

    int Descriptor() const noexcept { return descriptor_; }

    // What is sent to groups leaves from here.
    bool SendGroupsFrom(std::uint32_t interface_address) const noexcept;
    void Send(const Bytes& datagram, const Endpoint& to) const noexcept;
    // The next datagram, as long as its length says; none if there is none.
    std::optional<std::size_t> Receive(Bytes& buffer, Endpoint& from) const noexcept;

private:
    explicit UdpSocket(int descriptor) noexcept : descriptor_{descriptor} {}

    int descriptor_;
};

}  // namespace bench

#endif  // BENCH_NET_UDP_SOCKET_H_
