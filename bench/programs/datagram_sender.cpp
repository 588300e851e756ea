// Sends a datagram COUNT times: datagram_sender COUNT SENT. Its input says when.
#include "datagram.h"
#include "times.h"

int main(int, char** arguments) {
    const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
    const sockaddr_in to = Address();
    Datagram datagram{0xC8, 0xBB, 0xF5, 0x25, 0, 0, 0, 12, 0, 0, 0, 1, 1, 1, 2, 0};
    Write(arguments[2], Pace(std::stoul(arguments[1]), [&](float speed) {
              std::memcpy(datagram.data() + 16, &speed, sizeof speed);
              static_cast<void>(sendto(descriptor, datagram.data(), datagram.size(), 0,
                                       reinterpret_cast<const sockaddr*>(&to), sizeof to));
          }));
    return 0;
}
