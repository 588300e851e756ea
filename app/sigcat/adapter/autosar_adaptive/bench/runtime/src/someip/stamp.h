// The time at which an event was sent, in a separate message before it in its datagram: for recorders at a bench.
#ifndef BENCH_SOMEIP_STAMP_H_
#define BENCH_SOMEIP_STAMP_H_

#include <cstdint>
#include <optional>

#include "someip/message.h"

namespace bench {

// In ns of the machine's steady clock.
Bytes WrittenStamp(std::uint64_t time);

// None if it is no such message.
std::optional<std::uint64_t> StampOf(const Message& message);

}  // namespace bench

#endif  // BENCH_SOMEIP_STAMP_H_
