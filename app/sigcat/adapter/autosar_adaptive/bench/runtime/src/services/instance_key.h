// An instance of a service.
#ifndef BENCH_SERVICES_INSTANCE_KEY_H_
#define BENCH_SERVICES_INSTANCE_KEY_H_

#include <cstdint>
#include <utility>

namespace bench {

using InstanceKey = std::pair<std::uint16_t, std::uint16_t>;  // service, instance

}  // namespace bench

#endif  // BENCH_SERVICES_INSTANCE_KEY_H_
