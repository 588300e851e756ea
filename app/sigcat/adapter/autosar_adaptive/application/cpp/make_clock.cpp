#include "application/clock.h"

namespace application {

std::unique_ptr<Clock> MakeClock(const char* /* component */) { return std::make_unique<SteadyClock>(); }

}  // namespace application
