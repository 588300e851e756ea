#include "bench/reader.h"

#include <algorithm>

#include "someip/message.h"
#include "someip/utf.h"

namespace bench {

std::uint64_t Reader::Integer(std::size_t width) {
    Align();
    if (!Takes(width)) {
        return 0;
    }
    std::uint64_t value = 0;
    for (std::size_t n = 0; n < width; ++n) {
        const std::size_t place = serialization_.is_big_endian ? n : width - 1 - n;
        value = (value << 8) | bytes_[at_ + place];
    }
    at_ += width;
    return value;
}

std::string Reader::Text() {
    const auto part = Begin(serialization_.string_length);
    std::string text;
    if (is_valid_ && serialization_.is_utf16) {
        text = Utf16(part.end, serialization_.is_big_endian);
    } else if (is_valid_) {
        const auto* const begin = bytes_.begin() + at_;
        text.assign(begin, std::find(begin, bytes_.begin() + part.end, std::uint8_t{0}));
        if (text.rfind(std::string{kUtf8Mark.begin(), kUtf8Mark.end()}, 0) == 0) {
            text.erase(0, kUtf8Mark.size());
        }
    }
    End(part);
    EndOpen();
    return text;
}

Reader::Part Reader::Begin(std::size_t width) {
    const std::size_t outer = limit_;
    if (width == 0) {
        Align();
        return {outer, outer, false};
    }
    const auto length = static_cast<std::size_t>(Integer(width));
    if (!is_valid_ || length > limit_ - at_) {
        Fail();
        return {at_, outer, true};
    }
    limit_ = at_ + length;
    return {limit_, outer, true};
}

void Reader::End(const Part& part) {
    if (part.has_length) {
        at_ = is_valid_ ? part.end : at_;
        limit_ = part.outer;
    }
}

void Reader::Align() noexcept {
    if (aligns_) {
        aligns_ = false;
        const std::size_t past = (kHeaderLength + at_) % serialization_.alignment;
        at_ += past == 0 ? 0 : serialization_.alignment - past;
    }
}

bool Reader::Takes(std::size_t width) noexcept {
    if (is_valid_ && (at_ > limit_ || limit_ - at_ < width)) {
        Fail();
    }
    return is_valid_;
}

std::string Reader::Utf16(std::size_t end, bool is_big_endian) {
    std::u16string units;
    for (; is_valid_ && at_ + 2 <= end; at_ += 2) {
        const unsigned first = bytes_[at_];
        const unsigned second = bytes_[at_ + 1];
        const auto unit = static_cast<char16_t>(is_big_endian ? first << 8 | second : second << 8 | first);
        if (unit == 0xFFFE) {  // the mark says that it is the other way round
            is_big_endian = !is_big_endian;
        } else if (unit == 0) {
            break;
        } else if (unit != 0xFEFF) {
            units.push_back(unit);
        }
    }
    return ToUtf8(units);
}

}  // namespace bench
