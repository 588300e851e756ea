// How a type becomes bytes and is read of them. The generated codecs.cpp has the one of each type that is sent.
#ifndef BENCH_CODEC_H_
#define BENCH_CODEC_H_

#include <cstdint>
#include <vector>

#include "ara/core/span.h"
#include "bench/description.h"

namespace bench {

using Bytes = std::vector<std::uint8_t>;
using ByteView = ara::core::Span<const std::uint8_t>;

class Writer;
class Reader;

template <typename T>
struct Codec {
    static void Write(Writer& writer, const T& value);
    static void Read(Reader& reader, T& value);
};

}  // namespace bench

#endif  // BENCH_CODEC_H_
