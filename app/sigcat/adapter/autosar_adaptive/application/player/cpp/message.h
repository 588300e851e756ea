// What player and processes say to each other in lock-step, as datagrams of text.
//
//   process: hello NAME                               until it is answered
//   player:  NUMBER time T                            it is T, in ns
//            NUMBER go                                run what is due, and supervise
//            NUMBER ask
//   process: NUMBER SENT RECEIVED RUNNING MISSING NEXT   when that is done; again, if the number comes again

#ifndef PLAYER_MESSAGE_H
#define PLAYER_MESSAGE_H

#include <cstdint>
#include <string>

#include "bench/counters.h"

namespace player {

/// How far a process is.
struct Progress final {
    bench::Counters counters{};
    std::uint64_t next{0};  // when it wants to run again, in ns
};

/// A socket on the loopback interface.
class Socket final {
public:
    /// Throws std::runtime_error if there is none.
    explicit Socket(std::uint16_t port);
    ~Socket();
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;

    void Send(const std::string& text, std::uint16_t port) const;

    /// False if nothing comes in time.
    bool Receive(std::string& text, std::uint16_t& port, int milliseconds) const;

private:
    int socket_;
};

}  // namespace player

#endif  // PLAYER_MESSAGE_H
