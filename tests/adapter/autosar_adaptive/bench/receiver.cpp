// Uses the service of the tests. Tells what comes, and does what the lines of its input say.
#include <chrono>
#include <iostream>
#include <memory>
#include <mutex>
#include <numeric>
#include <sstream>
#include <string>

#include "ara/com/com_error_domain.h"
#include "ara/core/initialization.h"
#include "probe/demo/probeservice_proxy.h"

namespace {

using probe::demo::proxy::ProbeServiceProxy;
using namespace std::chrono_literals;

std::mutex output;  // lines of several threads

template <typename... Parts>
void Tell(const Parts&... parts) {
    std::lock_guard<std::mutex> lock{output};
    ((std::cout << parts), ...);
    std::cout << std::endl;
}

const char* Name(ara::com::SubscriptionState state) {
    switch (state) {
        case ara::com::SubscriptionState::kSubscribed:
            return "subscribed";
        case ara::com::SubscriptionState::kNotSubscribed:
            return "not subscribed";
        case ara::com::SubscriptionState::kSubscriptionPending:
            return "pending";
    }
    return "";
}

void TellTrack(const probe::demo::Track_T& track) {
    const auto corners = std::accumulate(track.corners.begin(), track.corners.end(), 0);
    Tell("track ", track.name, " ", static_cast<int>(track.mode), " ", corners, " ", track.flags.size(), " ",
         track.distance);
}

// Whether an image is what its sender makes.
bool IsWhole(const probe::demo::Image_T& image) {
    for (std::size_t n = 0; n < image.size(); ++n) {
        if (image[n] != n % 251) {
            return false;
        }
    }
    return true;
}

template <typename Event, typename F>
void Listen(Event& event, const char* name, F read) {
    static_cast<void>(event.SetSubscriptionStateChangeHandler(
        [name](ara::com::SubscriptionState state) { Tell(name, " is ", Name(state)); }));
    static_cast<void>(event.SetReceiveHandler([&event, name, read] {
        static_cast<void>(event.GetNewSamples([name, &read](auto sample) {
            read(*sample);
            if (sample.BenchSentAt().has_value()) {
                Tell(name, " was sent at ", *sample.BenchSentAt());
            }
        }));
    }));
    static_cast<void>(event.Subscribe(256));
}

void Subscribe(ProbeServiceProxy& proxy) {
    Listen(proxy.Speed, "Speed", [](float speed) { Tell("speed ", speed); });
    Listen(proxy.Track, "Track", TellTrack);
    Listen(proxy.Image, "Image", [](const probe::demo::Image_T& image) {
        Tell("image ", image.size(), IsWhole(image) ? " whole" : " broken");
    });
    Listen(proxy.Mode, "Mode", [](probe::demo::Mode_T mode) { Tell("mode ", static_cast<int>(mode)); });
}

template <typename T, typename F>
void Await(ara::core::Future<T> future, const char* name, F tell) {
    if (future.wait_for(1s) == ara::core::future_status::timeout) {
        Tell(name, " timed out");
        return;
    }
    auto result = future.GetResult();
    if (result) {
        tell(result);
    } else {
        Tell(name, " failed: ", result.Error().Message(), " ", result.Error().SupportData());
    }
}

void Do(ProbeServiceProxy& proxy, const std::string& line) {
    std::istringstream words{line};
    std::string command;
    words >> command;
    if (command == "subscribe") {
        Subscribe(proxy);
    } else if (command == "unsubscribe") {
        proxy.Speed.Unsubscribe();
        proxy.Track.Unsubscribe();
        proxy.Image.Unsubscribe();
        proxy.Mode.Unsubscribe();
    } else if (command == "add") {
        std::int32_t left = 0;
        std::int32_t right = 0;
        words >> left >> right;
        Await(proxy.Add(left, right), "add", [](const auto& result) { Tell("sum ", result.Value().sum); });
    } else if (command == "reset") {
        Await(proxy.Reset(), "reset", [](const auto&) { Tell("reset"); });
    } else if (command == "get") {
        Await(proxy.Mode.Get(), "get", [](const auto& result) { Tell("got ", static_cast<int>(result.Value())); });
    }
    Tell("done ", command);
}

}  // namespace

int main(int count, char** arguments) {
    if (auto started = ara::core::Initialize(); !started) {
        Tell(started.Error().Message());
        return 1;
    }
    {
        std::unique_ptr<ProbeServiceProxy> proxy;
        ara::core::Promise<ProbeServiceProxy::HandleType> found;
        auto handle = found.get_future();
        const bool takes_any = count > 1 && std::string{arguments[1]} == "any";
        const ara::com::FindServiceHandler<ProbeServiceProxy::HandleType> handler =
            [&found, was_found = false](const auto& handles, ara::com::FindServiceHandle) mutable {
                Tell("found ", handles.size());
                if (!handles.empty() && !was_found) {
                    was_found = true;
                    found.set_value(handles.front());
                }
            };
        auto search =
            takes_any
                ? ProbeServiceProxy::StartFindService(handler, ara::com::InstanceIdentifier{"SOME/IP:4660:65535"})
                : ProbeServiceProxy::StartFindService(
                      handler, ara::core::InstanceSpecifier{"ReceiverExecutable/Receiver_Root/ProbeService_RPort"});
        Tell("ready");
        for (std::string line; std::getline(std::cin, line) && line != "quit";) {
            if (proxy == nullptr) {
                proxy = std::make_unique<ProbeServiceProxy>(handle.get());
            }
            Do(*proxy, line);
        }
        ProbeServiceProxy::StopFindService(search.Value());
    }
    return ara::core::Deinitialize() ? 0 : 1;
}
