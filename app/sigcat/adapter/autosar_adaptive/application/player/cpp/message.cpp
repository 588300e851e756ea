#include "player/message.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace player {

namespace {

sockaddr_in Address(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

}  // namespace

Socket::Socket(std::uint16_t port) : socket_{::socket(AF_INET, SOCK_DGRAM, 0)} {
    const sockaddr_in address = Address(port);
    if (socket_ < 0 || ::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        throw std::runtime_error{"The port of the player cannot be used."};
    }
}

Socket::~Socket() { ::close(socket_); }

void Socket::Send(const std::string& text, std::uint16_t port) const {
    const sockaddr_in address = Address(port);
    static_cast<void>(
        ::sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address));
}

bool Socket::Receive(std::string& text, std::uint16_t& port, int milliseconds) const {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, milliseconds) <= 0) {
        return false;
    }
    char bytes[512];
    sockaddr_in from{};
    socklen_t size = sizeof from;
    const auto got = ::recvfrom(socket_, bytes, sizeof bytes, 0, reinterpret_cast<sockaddr*>(&from), &size);
    if (got < 0) {
        return false;
    }
    text.assign(bytes, static_cast<std::size_t>(got));
    port = ntohs(from.sin_port);
    return true;
}

}  // namespace player
