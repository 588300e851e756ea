#include "someip/utf.h"

namespace bench {
namespace {

constexpr char32_t kUnknown = 0xFFFD;

bool IsSurrogate(char32_t code) { return code >= 0xD800 && code <= 0xDFFF; }

// How many bytes follow the first one of a character; 4 if it is none.
std::size_t Following(unsigned char first) {
    if (first < 0x80) {
        return 0;
    }
    if (first >= 0xC2 && first <= 0xDF) {
        return 1;
    }
    if (first >= 0xE0 && first <= 0xEF) {
        return 2;
    }
    return first >= 0xF0 && first <= 0xF4 ? 3 : 4;
}

// The character at a place, which moves on behind it.
char32_t Next(const std::string& text, std::size_t& at) {
    const auto first = static_cast<unsigned char>(text[at++]);
    const std::size_t count = Following(first);
    if (count == 0) {
        return first;
    }
    if (count > 3) {
        return kUnknown;
    }
    char32_t code = first & (0x3FU >> count);
    for (std::size_t n = 0; n < count; ++n, ++at) {
        if (at >= text.size() || (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U) {
            return kUnknown;
        }
        code = (code << 6) | (static_cast<unsigned char>(text[at]) & 0x3FU);
    }
    const bool is_short = (count == 2 && code < 0x800) || (count == 3 && code < 0x10000);
    return is_short || code > 0x10FFFF || IsSurrogate(code) ? kUnknown : code;
}

void Append(std::string& text, char32_t code) {
    if (code < 0x80) {
        text.push_back(static_cast<char>(code));
        return;
    }
    const int count = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    const char32_t marks[] = {0, 0xC0, 0xE0, 0xF0};
    text.push_back(static_cast<char>(marks[count] | (code >> (6 * count))));
    for (int n = count - 1; n >= 0; --n) {
        text.push_back(static_cast<char>(0x80 | ((code >> (6 * n)) & 0x3F)));
    }
}

}  // namespace

std::u16string ToUtf16(const std::string& text) {
    std::u16string units;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t code = Next(text, at);
        if (code < 0x10000) {
            units.push_back(static_cast<char16_t>(code));
        } else {
            units.push_back(static_cast<char16_t>(0xD800 + ((code - 0x10000) >> 10)));
            units.push_back(static_cast<char16_t>(0xDC00 + ((code - 0x10000) & 0x3FF)));
        }
    }
    return units;
}

std::string ToUtf8(const std::u16string& units) {
    std::string text;
    for (std::size_t at = 0; at < units.size(); ++at) {
        const char32_t unit = units[at];
        const bool has_low = at + 1 < units.size() && units[at + 1] >= 0xDC00 && units[at + 1] <= 0xDFFF;
        if (unit >= 0xD800 && unit <= 0xDBFF && has_low) {
            Append(text, 0x10000 + ((unit - 0xD800) << 10) + (units[++at] - 0xDC00U));
        } else {
            Append(text, IsSurrogate(unit) ? kUnknown : unit);
        }
    }
    return text;
}

}  // namespace bench
