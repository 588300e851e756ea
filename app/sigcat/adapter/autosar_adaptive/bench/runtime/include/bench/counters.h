// How far a process is: whether something is under way, and whether it is connected. For who runs processes in lock-step.
#ifndef BENCH_COUNTERS_H_
#define BENCH_COUNTERS_H_

#include <cstddef>
#include <cstdint>

namespace bench {

struct Counters {
    std::uint64_t sent;      // messages of services, one for each receiver
    std::uint64_t received;  // those that have arrived, and were given to their receivers
    std::uint64_t running;   // handlers of the application that wait or run
    std::uint64_t missing;   // services and subscriptions that are sought and not there
};

Counters Count();

// Processes that have subscribed to an instance that this one offers.
std::size_t Subscribers(std::uint16_t service, std::uint16_t instance);

}  // namespace bench

#endif  // BENCH_COUNTERS_H_
