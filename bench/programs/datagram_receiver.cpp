// Receives a datagram COUNT times: datagram_receiver COUNT RECEIVED.
#include <sys/time.h>

#include "datagram.h"
#include "times.h"

int main(int, char** arguments) {
    const std::size_t count = std::stoul(arguments[1]);
    const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
    const timeval patience{60, 0};
    const sockaddr_in own = Address();
    static_cast<void>(setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience));
    if (bind(descriptor, reinterpret_cast<const sockaddr*>(&own), sizeof own) != 0) {
        return 1;
    }
    std::cout << "bound" << std::endl;
    std::vector<std::int64_t> times;
    times.reserve(count);
    Datagram datagram{};
    while (times.size() < count && recv(descriptor, datagram.data(), datagram.size(), 0) > 0) {
        times.push_back(Now());
    }
    Write(arguments[2], times);
    return 0;
}
