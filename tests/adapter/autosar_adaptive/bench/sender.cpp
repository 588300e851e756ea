// Offers the service of the tests. Does what the lines of its input say, and tells what it is asked.
#include <cstdint>
#include <iostream>
#include <sstream>
#include <string>

#include "ara/core/initialization.h"
#include "probe/demo/probeservice_skeleton.h"

namespace {

using ara::com::MethodCallProcessingMode;
using probe::demo::Mode_T;
using probe::demo::skeleton::ProbeServiceSkeleton;

class Sender final : public ProbeServiceSkeleton {
public:
    using ProbeServiceSkeleton::ProbeServiceSkeleton;

    ara::core::Future<AddOutput> Add(const std::int32_t& left, const std::int32_t& right) override {
        using Errc = probe::demo::FunctionMethodErrc;
        ara::core::Promise<AddOutput> promise;
        if (left < 0) {
            promise.SetError(right < 0 ? Errc::kBadArgument : Errc::kExcluded);
        } else if (right < 0) {
            promise.SetError(ara::core::future_errc::no_state);
        } else {
            promise.set_value(AddOutput{left + right});
        }
        return promise.get_future();
    }

    ara::core::Future<void> Reset() override {
        std::cout << "reset" << std::endl;
        ara::core::Promise<void> promise;
        promise.set_value();
        return promise.get_future();
    }
};

probe::demo::Track_T Track(const std::string& name) {
    return {name, Mode_T::ON, {1, -2, 3, -4}, {true, false, true}, 0.5};
}

void Do(Sender& sender, const std::string& line) {
    std::istringstream words{line};
    std::string command;
    words >> command;
    bool done = true;
    if (command == "offer") {
        done = sender.OfferService().HasValue();
    } else if (command == "stop") {
        sender.StopOfferService();
    } else if (command == "speed") {
        float value = 0;
        words >> value;
        done = sender.Speed.Send(value).HasValue();
    } else if (command == "speeds") {
        int count = 0;
        words >> count;
        for (int n = 0; n < count; ++n) {
            auto sample = sender.Speed.Allocate();
            *sample.Value() = static_cast<float>(n);
            done = sender.Speed.Send(std::move(sample).Value()).HasValue() && done;
        }
    } else if (command == "track") {
        std::string name;
        words >> name;
        done = sender.Track.Send(Track(name)).HasValue();
    } else if (command == "image") {
        std::size_t size = 0;
        words >> size;
        probe::demo::Image_T image(size);
        for (std::size_t n = 0; n < size; ++n) {
            image[n] = static_cast<std::uint8_t>(n % 251);
        }
        done = sender.Image.Send(image).HasValue();
    } else if (command == "mode") {
        int value = 0;
        words >> value;
        done = sender.Mode.Update(static_cast<Mode_T>(value)).HasValue();
    } else if (command == "process") {
        done = sender.ProcessNextMethodCall().GetResult().ValueOr(false);
    }
    std::cout << (done ? "done " : "refused ") << command << std::endl;
}

}  // namespace

int main(int count, char** arguments) {
    if (auto started = ara::core::Initialize(); !started) {
        std::cout << started.Error().Message() << std::endl;
        return 1;
    }
    {
        const bool polls = count > 1 && std::string{arguments[1]} == "poll";
        Sender sender{ara::core::InstanceSpecifier{"SenderExecutable/Sender_Root/ProbeService_PPort"},
                      polls ? MethodCallProcessingMode::kPoll : MethodCallProcessingMode::kEvent};
        std::cout << "ready" << std::endl;
        for (std::string line; std::getline(std::cin, line) && line != "quit";) {
            Do(sender, line);
        }
        sender.StopOfferService();
    }
    return ara::core::Deinitialize() ? 0 : 1;
}
