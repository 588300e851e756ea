// Sends an event COUNT times: event_sender COUNT SENT. Its input says when.
#include "ara/core/initialization.h"
#include "eco_control/vehicleservice_skeleton.h"
#include "times.h"

int main(int, char** arguments) {
    if (!ara::core::Initialize()) {
        return 1;
    }
    {
        eco_control::skeleton::VehicleServiceSkeleton service{
            ara::core::InstanceSpecifier{"Player/Player_Root/VehicleService_PPort"}};
        if (!service.OfferService()) {
            return 1;
        }
        Write(arguments[2], Pace(std::stoul(arguments[1]), [&service](float speed) {
                  static_cast<void>(service.Vehicle_Speed.Send(speed));
              }));
        AwaitReceiver();  // the end of an offer may overtake the last event
    }
    return ara::core::Deinitialize() ? 0 : 1;
}
