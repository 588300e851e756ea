// Numbers of headers, which are big endian always.
#ifndef BENCH_SOMEIP_BIG_ENDIAN_H_
#define BENCH_SOMEIP_BIG_ENDIAN_H_

#include <cstdint>

#include "bench/codec.h"

namespace bench {

inline void Append(Bytes& bytes, std::uint32_t value, std::size_t width) {
    for (std::size_t n = width; n-- > 0;) {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * n)));
    }
}

inline std::uint32_t NumberAt(ByteView bytes, std::size_t at, std::size_t width) {
    std::uint32_t value = 0;
    for (std::size_t n = 0; n < width; ++n) {
        value = (value << 8) | bytes[at + n];
    }
    return value;
}

inline std::uint16_t ShortAt(ByteView bytes, std::size_t at) {
    return static_cast<std::uint16_t>(NumberAt(bytes, at, 2));
}

}  // namespace bench

#endif  // BENCH_SOMEIP_BIG_ENDIAN_H_
