// Everything of ara::com that a process has once: sockets, threads, and what it searches, uses and offers.
//
// One thread receives and keeps times; a second one (dispatcher.h) runs what applications register. One lock guards all
// state but the queues of events, which have their own, so that reading them never waits for the network.
#ifndef BENCH_SERVICES_RUNTIME_H_
#define BENCH_SERVICES_RUNTIME_H_

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <vector>

#include "bench/description.h"
#include "discovery/outbox.h"
#include "net/timers.h"
#include "services/consumer.h"
#include "services/dispatcher.h"
#include "services/network.h"
#include "services/provider.h"
#include "services/searches.h"
#include "someip/segments.h"

namespace bench {

class Runtime {
public:
    using Lock = std::unique_lock<std::mutex>;

    static Runtime& Get();

    // False if the network cannot be used.
    bool Start();
    void Stop();

    // Before any other of the following.
    Lock Locked();
    // A change may have come before what the thread waits for.
    void Wake();

    Timers& Later() noexcept { return timers_; }
    Outbox& Discovery() noexcept { return outbox_; }
    Dispatcher& Handlers() noexcept { return dispatcher_; }
    Searches& Sought() noexcept { return searches_; }
    Consumer& Used() noexcept { return consumer_; }
    Provider& Offered() noexcept { return provider_; }

    bool IsRunning() const noexcept { return network_ != nullptr; }
    Endpoint ServiceEndpoint() const noexcept { return network_->ServiceEndpoint(); }
    Milliseconds Between(double low, double high) { return Milliseconds{std::uniform_real_distribution{low, high}(random_)}; }
    void Send(const Header& header, ByteView payload, const Endpoint& to);
    std::uint64_t Sent() const noexcept { return sent_; }
    std::uint64_t Received() const noexcept { return received_; }
    // Called without the lock, by the thread that receives: what futures continue with.
    void Unlocked(std::function<void()> action) { unlocked_.push_back(std::move(action)); }

private:
    void Run();
    void RunDue();
    void AwaitDatagrams(Timers::Id::first_type until, bool has_until);
    void ReceiveAll(const UdpSocket& socket, void (Runtime::*take)(ByteView, const Endpoint&));
    void TakeDiscovery(ByteView datagram, const Endpoint& from);
    void TakeGroupDiscovery(ByteView datagram, const Endpoint& from);
    void TakeEntries(ByteView datagram, const Endpoint& from, bool is_multicast);
    void TakeEntry(const Entry& entry, const Endpoint& from, bool is_multicast);
    void TakeMessages(ByteView datagram, const Endpoint& from);
    void TakeMessage(const Message& message, const Endpoint& from);
    void Finish(Lock lock);

    std::mutex mutex_;
    std::unique_ptr<Network> network_;
    int wake_ = -1;
    std::atomic<bool> stops_{false};
    bool stamps_ = false;  // whether events tell when they were sent
    std::thread thread_;
    std::minstd_rand random_{std::random_device{}()};
    Bytes buffer_;
    std::uint64_t sent_ = 0;
    std::uint64_t received_ = 0;
    std::vector<std::function<void()>> unlocked_;

    Timers timers_;
    Outbox outbox_;
    Peers peers_;
    Reassembly reassembly_;
    Dispatcher dispatcher_;
    Searches searches_{*this};
    Consumer consumer_{*this};
    Provider provider_{*this};
};

}  // namespace bench

#endif  // BENCH_SERVICES_RUNTIME_H_
