#pragma once

namespace demo {

class Controller {
public:
    bool init();
    void step();
    void terminate();

    float speed = 0.0F;
    float gain = 0.0F;
    float out = 0.0F;
};

}  // namespace demo
