// Entries on their way: those to one receiver that come up together travel together.
#ifndef BENCH_DISCOVERY_OUTBOX_H_
#define BENCH_DISCOVERY_OUTBOX_H_

#include <functional>
#include <map>
#include <vector>

#include "discovery/entry.h"
#include "discovery/peers.h"
#include "net/udp_socket.h"

namespace bench {

class Outbox {
public:
    void Add(const Endpoint& to, const Entry& entry) { entries_[to].push_back(entry); }
    // What is done when everything before it has been sent.
    void Afterwards(std::function<void()> action) { afterwards_.push_back(std::move(action)); }

    bool IsEmpty() const noexcept { return entries_.empty() && afterwards_.empty(); }
    void Flush(const UdpSocket& socket);

private:
    std::map<Endpoint, std::vector<Entry>> entries_;
    std::map<Endpoint, SessionCounter> sessions_;
    std::vector<std::function<void()>> afterwards_;
};

}  // namespace bench

#endif  // BENCH_DISCOVERY_OUTBOX_H_
