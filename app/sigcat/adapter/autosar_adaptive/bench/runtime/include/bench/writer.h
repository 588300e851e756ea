// Values to bytes, as the serialization of SOME/IP has them.
#ifndef BENCH_WRITER_H_
#define BENCH_WRITER_H_

#include <cstdint>
#include <string>

#include "bench/codec.h"

namespace bench {

class Writer {
public:
    explicit Writer(const Serialization& serialization) : serialization_{serialization} {}

    const Bytes& Payload() const noexcept { return bytes_; }
    const Serialization& Settings() const noexcept { return serialization_; }

    // An integer of `width` bytes.
    void Integer(std::uint64_t value, std::size_t width);
    void Text(const std::string& text);

    // The length before an array or a struct, which `EndLength` fills in; nothing where its width is 0.
    std::size_t BeginLength(std::size_t width);
    void EndLength(std::size_t begin, std::size_t width);

    // What was written is of open length: what follows is aligned.
    void EndOpen() noexcept { aligns_ = serialization_.alignment > 1; }

private:
    void Align();
    void Put(std::uint64_t value, std::size_t width, std::size_t at);

    const Serialization& serialization_;
    Bytes bytes_;
    bool aligns_ = false;
};

}  // namespace bench

#endif  // BENCH_WRITER_H_
