#include "controller.hpp"

extern "C" float helper(float value);

namespace demo {

bool Controller::init()
{
    gain = 0.0F;
    return true;
}

void Controller::step()
{
    out = helper(speed * gain);
}

void Controller::terminate() {}

}  // namespace demo
