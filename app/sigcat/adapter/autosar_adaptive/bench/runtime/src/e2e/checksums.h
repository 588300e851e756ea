// Checksums of end-to-end protection (AUTOSAR, CRC routines): each continues the one of the bytes before.
#ifndef BENCH_E2E_CHECKSUMS_H_
#define BENCH_E2E_CHECKSUMS_H_

#include <cstdint>

#include "bench/codec.h"

namespace bench {

std::uint64_t Crc16(std::uint64_t checksum, ByteView bytes) noexcept;
std::uint64_t Crc32P4(std::uint64_t checksum, ByteView bytes) noexcept;
std::uint64_t Crc64(std::uint64_t checksum, ByteView bytes) noexcept;

}  // namespace bench

#endif  // BENCH_E2E_CHECKSUMS_H_
