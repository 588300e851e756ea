// Receives an event COUNT times, and gives each to a core: event_receiver COUNT READ DONE.
// READ has when each was read; DONE when its SetInput and GetOutput were done, too.
#include <condition_variable>
#include <memory>
#include <mutex>

#include "ara/core/initialization.h"
#include "core/CoreAcc_adapter.h"
#include "eco_control/vehicleservice_proxy.h"
#include "times.h"

namespace {

using eco_control::proxy::VehicleServiceProxy;
constexpr std::chrono::seconds kPatience{60};

class Receiver {
public:
    explicit Receiver(std::size_t count) : count_{count} {
        read.reserve(count);
        done.reserve(count);
        static_cast<void>(CoreAcc_Adapter_Init(&core_, nullptr, 1U));
        CoreAcc_Adapter_Start(&core_, static_cast<std::uint64_t>(Now()));
    }

    void Use(const VehicleServiceProxy::HandleType& handle) {
        proxy_ = std::make_unique<VehicleServiceProxy>(handle);
        auto& event = proxy_->Vehicle_Speed;
        static_cast<void>(event.SetSubscriptionStateChangeHandler([](ara::com::SubscriptionState state) {
            if (state == ara::com::SubscriptionState::kSubscribed) {
                std::cout << "subscribed" << std::endl;
            }
        }));
        static_cast<void>(event.SetReceiveHandler(
            [this, &event] { static_cast<void>(event.GetNewSamples([this](const auto& sample) { Take(*sample); })); }));
        static_cast<void>(event.Subscribe(256));
    }

    // Whether all have come.
    bool Await() {
        std::unique_lock<std::mutex> lock{mutex_};
        return all_.wait_for(lock, kPatience, [this] { return done.size() >= count_; });
    }

    void Leave() { proxy_.reset(); }

    std::vector<std::int64_t> read;
    std::vector<std::int64_t> done;

private:
    void Take(float speed) {
        const auto now = Now();
        const auto time = static_cast<std::uint64_t>(now);
        CoreAcc_Adapter_Receive_EgoVehSpd(&core_, speed, time);
        CoreAcc_Adapter_SetInput_Step(&core_, time);
        CoreAcc_Adapter_GetOutput_Step(&core_, time);
        const auto end = Now();
        const std::lock_guard<std::mutex> lock{mutex_};
        read.push_back(now);
        done.push_back(end);
        if (done.size() == count_) {
            all_.notify_all();
        }
    }

    std::size_t count_;
    CoreAcc_Adapter& core_ = CoreAcc_Adapter_Instance;
    std::unique_ptr<VehicleServiceProxy> proxy_;
    std::mutex mutex_;
    std::condition_variable all_;
};

}  // namespace

int main(int, char** arguments) {
    if (!ara::core::Initialize()) {
        return 1;
    }
    bool have_all = false;
    {
        Receiver receiver{std::stoul(arguments[1])};
        auto search = VehicleServiceProxy::StartFindService(
            [&receiver, was_found = false](const auto& handles, ara::com::FindServiceHandle) mutable {
                if (!handles.empty() && !was_found) {
                    was_found = true;
                    receiver.Use(handles.front());
                }
            },
            ara::core::InstanceSpecifier{"CoreAccExecutable/CoreAcc_Root/VehicleService_RPort"});
        have_all = receiver.Await();
        VehicleServiceProxy::StopFindService(search.Value());
        receiver.Leave();
        Write(arguments[2], receiver.read);
        Write(arguments[3], receiver.done);
    }
    return ara::core::Deinitialize() && have_all ? 0 : 1;
}
