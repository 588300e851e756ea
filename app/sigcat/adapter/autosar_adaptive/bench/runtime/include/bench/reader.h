// Bytes to values. What comes from the network may be anything: a reader that failed gives zeros and says so.
#ifndef BENCH_READER_H_
#define BENCH_READER_H_

#include <cstdint>
#include <string>

#include "bench/codec.h"

namespace bench {

class Reader {
public:
    // An array, a text or a struct: its end, and that of the value around it.
    struct Part {
        std::size_t end;
        std::size_t outer;
        bool has_length;
    };

    Reader(ByteView bytes, const Serialization& serialization)
        : bytes_{bytes}, serialization_{serialization}, limit_{bytes.size()} {}

    bool IsValid() const noexcept { return is_valid_; }
    const Serialization& Settings() const noexcept { return serialization_; }

    std::uint64_t Integer(std::size_t width);
    std::string Text();

    // What begins here ends with the length before it; where the width of that is 0, it ends with the value around it.
    Part Begin(std::size_t width);
    // Goes to its end: what a newer side has added there is left out.
    void End(const Part& part);

    // Whether there is more of a part.
    bool IsBefore(const Part& part) const noexcept { return is_valid_ && at_ < part.end; }
    std::size_t At() const noexcept { return at_; }
    void EndOpen() noexcept { aligns_ = serialization_.alignment > 1; }
    void Fail() noexcept { is_valid_ = false; }

private:
    void Align() noexcept;
    bool Takes(std::size_t width) noexcept;
    std::string Utf16(std::size_t end, bool is_big_endian);

    ByteView bytes_;
    const Serialization& serialization_;
    std::size_t at_ = 0;
    std::size_t limit_;
    bool aligns_ = false;
    bool is_valid_ = true;
};

}  // namespace bench

#endif  // BENCH_READER_H_
