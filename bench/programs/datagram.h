// A datagram as long as the event's: 16 bytes of header and a float.
#ifndef BENCH_PROGRAMS_DATAGRAM_H_
#define BENCH_PROGRAMS_DATAGRAM_H_

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstring>

using Datagram = std::array<unsigned char, 20>;

inline sockaddr_in Address() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(0x7F000002);
    address.sin_port = htons(30509);
    return address;
}

#endif  // BENCH_PROGRAMS_DATAGRAM_H_
