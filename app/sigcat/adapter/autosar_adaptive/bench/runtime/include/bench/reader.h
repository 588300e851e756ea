// Bytes to values. What comes from the network may be anything: a reader that failed gives zeros and says so.
#ifndef BENCH_READER_H_
#define BENCH_READER_H_

#include <cstdint>
#include <string>

#include "bench/codec.h"

namespace bench {

class Reader {
public:
    Reader(ByteView bytes, const Serialization& serialization) : bytes_{bytes}, serialization_{serialization} {}

    bool IsValid() const noexcept { return is_valid_; }
    const Serialization& Settings() const noexcept { return serialization_; }

    std::uint64_t Integer(std::size_t width);
    std::string Text();

    // Where what begins here ends: after its length, or at the end of everything where the width is 0.
    std::size_t BeginLength(std::size_t width);
    // Goes there; what a newer side has added before is left out.
    void EndLength(std::size_t end, std::size_t outer);

    bool IsBefore(std::size_t end) const noexcept { return is_valid_ && at_ < end; }
    std::size_t Limit() const noexcept { return limit_ < bytes_.size() ? limit_ : bytes_.size(); }
    void EndOpen() noexcept { aligns_ = serialization_.alignment > 1; }
    void Fail() noexcept { is_valid_ = false; }

private:
    void Align() noexcept;
    bool Takes(std::size_t width) noexcept;
    std::string Utf16(std::size_t end, bool is_big_endian);

    ByteView bytes_;
    const Serialization& serialization_;
    std::size_t at_ = 0;
    std::size_t limit_ = static_cast<std::size_t>(-1);
    bool aligns_ = false;
    bool is_valid_ = true;
};

}  // namespace bench

#endif  // BENCH_READER_H_
