// Texts in UTF-8, as applications have them, and in UTF-16.
#ifndef BENCH_SOMEIP_UTF_H_
#define BENCH_SOMEIP_UTF_H_

#include <array>
#include <cstdint>
#include <string>

namespace bench {

constexpr std::array<std::uint8_t, 3> kUtf8Mark{0xEF, 0xBB, 0xBF};

// What is not UTF-8, or no pair of UTF-16, becomes the replacement character.
std::u16string ToUtf16(const std::string& text);
std::string ToUtf8(const std::u16string& units);

}  // namespace bench

#endif  // BENCH_SOMEIP_UTF_H_
