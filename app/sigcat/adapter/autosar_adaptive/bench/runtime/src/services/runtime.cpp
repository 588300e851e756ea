#include "services/runtime.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdlib>
#include <utility>

#include "ara/core/abort.h"
#include "discovery/discovery_message.h"
#include "someip/stamp.h"

namespace bench {
namespace {

constexpr std::size_t kLongestDatagram = 65536;
constexpr int kDatagramsInTurn = 64;  // of one socket, before times and other sockets are looked at again

std::uint64_t SteadyTime() {
    const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::nanoseconds>(since_start).count());
}

}  // namespace

Runtime& Runtime::Get() {
    // Never destroyed: a thread of the application may use it while the process ends.
    static Runtime& runtime = *new Runtime;
    return runtime;
}

bool Runtime::Start() {
    Lock lock{mutex_};
    if (IsRunning()) {
        return true;
    }
    network_ = OpenNetwork();
    if (network_ == nullptr) {
        return false;
    }
    stamps_ = std::getenv("BENCH_STAMPS") != nullptr;
    wake_ = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    buffer_.resize(kLongestDatagram);
    outbox_ = Outbox{};
    peers_ = Peers{};
    stops_ = false;
    dispatcher_.Start();
    thread_ = std::thread{[this] { Run(); }};
    return true;
}

void Runtime::Stop() {
    {
        Lock lock{mutex_};
        if (!IsRunning()) {
            return;
        }
        provider_.StopAll();
        outbox_.Flush(network_->discovery);
    }
    stops_ = true;
    Wake();
    thread_.join();
    dispatcher_.Stop();
    Lock lock{mutex_};
    timers_.Clear();
    consumer_.Clear();
    searches_.Clear();
    close(wake_);
    network_.reset();
    Finish(std::move(lock));
}

Runtime::Lock Runtime::Locked() { return Lock{mutex_}; }

void Runtime::Wake() {
    const std::uint64_t one = 1;
    static_cast<void>(write(wake_, &one, sizeof one));
}

void Runtime::Send(const Header& header, ByteView payload, const Endpoint& to) {
    ++sent_;
    std::vector<Bytes> datagrams = Datagrams(header, payload);
    if (stamps_ && header.Is(MessageType::kNotification)) {
        const Bytes stamp = WrittenStamp(SteadyTime());
        datagrams.back().insert(datagrams.back().begin(), stamp.begin(), stamp.end());
    }
    for (const Bytes& datagram : datagrams) {
        network_->services.Send(datagram, to);
    }
}

void Runtime::Run() {
    while (!stops_) {
        Lock lock{mutex_};
        timers_.RunDue(Clock::now());
        while (!outbox_.IsEmpty()) {
            outbox_.Flush(network_->discovery);
        }
        const auto next = timers_.Next();
        Finish(std::move(lock));
        AwaitDatagrams(next.value_or(Clock::time_point{}), next.has_value());
    }
}

void Runtime::AwaitDatagrams(Clock::time_point until, bool has_until) {
    pollfd waited[] = {{network_->discovery.Descriptor(), POLLIN, 0},
                       {network_->group.Descriptor(), POLLIN, 0},
                       {network_->services.Descriptor(), POLLIN, 0},
                       {wake_, POLLIN, 0}};
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(until - Clock::now()).count();
    const auto nanoseconds = left > 0 ? left : 0;
    const timespec timeout{static_cast<time_t>(nanoseconds / 1'000'000'000),
                           static_cast<long>(nanoseconds % 1'000'000'000)};
    if (ppoll(waited, 4, has_until ? &timeout : nullptr, nullptr) <= 0) {
        return;
    }
    if (waited[3].revents != 0) {
        std::uint64_t count = 0;
        static_cast<void>(read(wake_, &count, sizeof count));
    }
    // An acknowledgement comes before the values that it announces, and the end of an offer after the last of them.
    if (waited[0].revents != 0) {
        ReceiveAll(network_->discovery, &Runtime::TakeDiscovery);
    }
    if (waited[2].revents != 0) {
        ReceiveAll(network_->services, &Runtime::TakeMessages);
    }
    if (waited[1].revents != 0) {
        ReceiveAll(network_->group, &Runtime::TakeGroupDiscovery);
    }
}

void Runtime::ReceiveAll(const UdpSocket& socket, void (Runtime::*take)(ByteView, const Endpoint&)) {
    Endpoint from{};
    for (int n = 0; n < kDatagramsInTurn; ++n) {
        const auto length = socket.Receive(buffer_, from);
        if (!length.has_value()) {
            return;
        }
        Lock lock{mutex_};
        (this->*take)(ByteView{buffer_.data(), *length}, from);
        Finish(std::move(lock));
    }
}

void Runtime::TakeDiscovery(ByteView datagram, const Endpoint& from) { TakeEntries(datagram, from, false); }

void Runtime::TakeGroupDiscovery(ByteView datagram, const Endpoint& from) { TakeEntries(datagram, from, true); }

void Runtime::TakeEntries(ByteView datagram, const Endpoint& from, bool is_multicast) {
    while (const auto message = NextMessage(datagram)) {
        const auto parsed = ParseDiscovery(*message);
        if (!parsed.has_value()) {
            continue;
        }
        if (peers_.HasRebooted(from, is_multicast, parsed->has_rebooted, parsed->session)) {
            peers_.Forget(from, is_multicast);
            consumer_.Lost(from);
            provider_.Lost(from);
        }
        for (const Entry& entry : parsed->entries) {
            TakeEntry(entry, from, is_multicast);
        }
    }
}

void Runtime::TakeEntry(const Entry& entry, const Endpoint& from, bool is_multicast) {
    switch (entry.type) {
        case EntryType::kFind:
            provider_.Answer(entry, from, is_multicast);
            break;
        case EntryType::kOffer:
            consumer_.TakeOffer(entry, from, is_multicast);
            break;
        case EntryType::kSubscribe:
            provider_.TakeSubscription(entry, from);
            break;
        case EntryType::kSubscribeAck:
            consumer_.TakeAcknowledgement(entry, from);
            break;
    }
}

void Runtime::TakeMessages(ByteView datagram, const Endpoint& from) {
    std::optional<std::uint64_t> sent_at;  // of the message after it
    while (auto message = NextMessage(datagram)) {
        if (const auto stamp = StampOf(*message)) {
            sent_at = stamp;
            continue;
        }
        message->sent_at = std::exchange(sent_at, std::nullopt);
        if ((message->header.type & kSegment) == 0) {
            TakeMessage(*message, from);
        } else if (const auto payload = reassembly_.Add(*message, from)) {
            Message whole{message->header, *payload, message->sent_at};
            whole.header.type = static_cast<std::uint8_t>(whole.header.type & ~kSegment);
            TakeMessage(whole, from);
        }
    }
}

void Runtime::TakeMessage(const Message& message, const Endpoint& from) {
    const Header& header = message.header;
    if (header.Is(MessageType::kNotification)) {
        consumer_.TakeEvent(message, from);
    } else if (header.Is(MessageType::kResponse) || header.Is(MessageType::kError)) {
        consumer_.TakeAnswer(message, from);
    } else if (header.Is(MessageType::kRequest) || header.Is(MessageType::kRequestNoReturn)) {
        provider_.TakeRequest(message, from);
    }
    ++received_;
}

void Runtime::Finish(Lock lock) {
    const auto actions = std::exchange(unlocked_, {});
    lock.unlock();
    for (const auto& action : actions) {
        action();
    }
}

}  // namespace bench
