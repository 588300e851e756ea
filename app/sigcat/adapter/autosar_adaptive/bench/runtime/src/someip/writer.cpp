#include "bench/writer.h"

#include "someip/message.h"
#include "someip/utf.h"

namespace bench {

void Writer::Integer(std::uint64_t value, std::size_t width) {
    Align();
    const std::size_t at = bytes_.size();
    bytes_.resize(at + width);
    Put(value, width, at);
}

void Writer::Text(const std::string& text) {
    const auto begin = BeginLength(serialization_.string_length);
    if (serialization_.is_utf16) {
        Integer(0xFEFF, 2);
        for (const char16_t unit : ToUtf16(text)) {
            Integer(unit, 2);
        }
        Integer(0, 2);
    } else {
        bytes_.insert(bytes_.end(), kUtf8Mark.begin(), kUtf8Mark.end());
        bytes_.insert(bytes_.end(), text.begin(), text.end());
        bytes_.push_back(0);
    }
    EndLength(begin, serialization_.string_length);
    EndOpen();
}

std::size_t Writer::BeginLength(std::size_t width) {
    if (width > 0) {
        Integer(0, width);
    } else {
        Align();
    }
    return bytes_.size();
}

void Writer::EndLength(std::size_t begin, std::size_t width) {
    Put(bytes_.size() - begin, width, begin - width);
}

void Writer::Align() {
    if (aligns_) {
        aligns_ = false;
        while ((kHeaderLength + bytes_.size()) % serialization_.alignment != 0) {
            bytes_.push_back(0);
        }
    }
}

void Writer::Put(std::uint64_t value, std::size_t width, std::size_t at) {
    for (std::size_t n = 0; n < width; ++n) {
        const std::size_t place = serialization_.is_big_endian ? width - 1 - n : n;
        bytes_[at + place] = static_cast<std::uint8_t>(value >> (8 * n));
    }
}

}  // namespace bench
