#include "bench/counters.h"

#include "services/runtime.h"

namespace bench {

Counters Count() {
    Runtime& runtime = Runtime::Get();
    const auto lock = runtime.Locked();
    return {runtime.Sent(), runtime.Received(), runtime.Handlers().Running(),
            runtime.Sought().Missing() + runtime.Used().Missing()};
}

std::size_t Subscribers(std::uint16_t service, std::uint16_t instance) {
    Runtime& runtime = Runtime::Get();
    const auto lock = runtime.Locked();
    return runtime.Offered().Subscribers({service, instance});
}

}  // namespace bench
