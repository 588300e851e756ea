// A provider and its consumers in one process, which begin, end and move in the middle of everything, for as many rounds as
// the argument says: handlers run while what they belong to is destroyed.
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "ara/core/initialization.h"
#include "probe/demo/probeservice_proxy.h"
#include "probe/demo/probeservice_skeleton.h"

namespace {

using namespace std::chrono_literals;
using probe::demo::proxy::ProbeServiceProxy;
using probe::demo::skeleton::ProbeServiceSkeleton;

const ara::core::InstanceSpecifier kProvided{"SenderExecutable/Sender_Root/ProbeService_PPort"};
const ara::core::InstanceSpecifier kRequired{"ReceiverExecutable/Receiver_Root/ProbeService_RPort"};

std::atomic<int> received{0};
std::atomic<int> answered{0};

class Provider final : public ProbeServiceSkeleton {
public:
    Provider() : ProbeServiceSkeleton{kProvided} {}
    Provider(Provider&&) noexcept = default;

    ara::core::Future<AddOutput> Add(const std::int32_t& left, const std::int32_t& right) override {
        auto promise = std::make_shared<ara::core::Promise<AddOutput>>();
        auto future = promise->get_future();
        // Answers later, from another thread, perhaps when there is no provider any more.
        std::thread{[promise, sum = left + right] {
            std::this_thread::sleep_for(1ms);
            promise->set_value(AddOutput{sum});
        }}.detach();
        return future;
    }
    ara::core::Future<void> Reset() override {
        ara::core::Promise<void> promise;
        promise.set_value();
        return promise.get_future();
    }
};

// Sends and changes until it is told to end.
void Provide(const std::atomic<bool>& ends, int rounds) {
    for (int round = 0; round < rounds && !ends; ++round) {
        Provider first;
        static_cast<void>(first.Mode.Update(probe::demo::Mode_T::ON));
        Provider provider{std::move(first)};
        static_cast<void>(provider.OfferService());
        for (int n = 0; n < 200 && !ends; ++n) {
            static_cast<void>(provider.Speed.Send(static_cast<float>(n)));
            static_cast<void>(provider.Mode.Update(probe::demo::Mode_T::OFF));
            std::this_thread::sleep_for(500us);
        }
        provider.StopOfferService();
    }
}

void Use(ProbeServiceProxy& proxy) {
    static_cast<void>(proxy.Speed.SetSubscriptionStateChangeHandler([](ara::com::SubscriptionState) {}));
    static_cast<void>(proxy.Speed.SetReceiveHandler([&proxy] {
        static_cast<void>(proxy.Speed.GetNewSamples([](ara::com::SamplePtr<const float>) { ++received; }));
    }));
    static_cast<void>(proxy.Mode.Subscribe(4));
    static_cast<void>(proxy.Speed.Subscribe(8));
    auto sum = proxy.Add(1, 2).then([](auto done) {
        answered += done.GetResult() ? 1 : 0;
    });
    static_cast<void>(sum.wait_for(3ms));
    std::this_thread::sleep_for(5ms);
    static_cast<void>(proxy.Mode.GetNewSamples([](auto) {}));
}

void Consume(int rounds) {
    for (int round = 0; round < rounds; ++round) {
        std::unique_ptr<ProbeServiceProxy> found;
        std::mutex mutex;
        auto search = ProbeServiceProxy::StartFindService(
            [&](const auto& handles, ara::com::FindServiceHandle handle) {
                std::lock_guard<std::mutex> lock{mutex};
                if (!handles.empty() && found == nullptr) {
                    found = std::make_unique<ProbeServiceProxy>(handles.front());
                    ProbeServiceProxy::StopFindService(handle);
                }
            },
            kRequired);
        std::this_thread::sleep_for(10ms);
        ProbeServiceProxy::StopFindService(search.Value());
        if (found != nullptr) {
            Use(*found);
        }
    }
}

}  // namespace

int main(int, char** arguments) {
    const int rounds = std::atoi(arguments[1]);
    if (!ara::core::Initialize()) {
        return 1;
    }
    std::atomic<bool> ends{false};
    std::thread provider{[&ends] { Provide(ends, 1'000'000); }};
    std::vector<std::thread> consumers;
    for (int n = 0; n < 3; ++n) {
        consumers.emplace_back([rounds] { Consume(rounds); });
    }
    for (auto& consumer : consumers) {
        consumer.join();
    }
    ends = true;
    provider.join();
    std::cout << (received > 0 && answered > 0 ? "done" : "nothing came") << std::endl;
    std::this_thread::sleep_for(50ms);  // for answers that are late
    return ara::core::Deinitialize() ? 0 : 1;
}
