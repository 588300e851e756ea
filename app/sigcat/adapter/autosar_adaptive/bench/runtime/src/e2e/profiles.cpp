#include "e2e/profiles.h"

#include <array>

#include "e2e/checksums.h"

namespace bench {
namespace {

constexpr Place kNowhere{0, 0};
constexpr Profile kProfile4{12, {8, 4}, {0, 2}, {2, 2}, {4, 4}, false, &Crc32P4};
constexpr Profile kProfile5{3, {0, 2}, kNowhere, {2, 1}, kNowhere, true, &Crc16};
constexpr Profile kProfile6{5, {0, 2}, {2, 2}, {4, 1}, kNowhere, false, &Crc16};
constexpr Profile kProfile7{20, {0, 8}, {8, 4}, {12, 4}, {16, 4}, false, &Crc64};

// How far a byte of a number is shifted.
std::size_t Shift(std::size_t n, std::size_t width, bool is_little_endian) noexcept {
    return 8 * (is_little_endian ? n : width - 1 - n);
}

// All bits set, in so many bytes.
std::uint64_t Ones(std::size_t width) noexcept { return ~std::uint64_t{0} >> (64 - 8 * width); }

}  // namespace

std::uint64_t Profile::Read(ByteView header_bytes, const Place& place) const noexcept {
    std::uint64_t value = 0;
    for (std::size_t n = 0; n < place.width; ++n) {
        value |= std::uint64_t{header_bytes[place.at + n]} << Shift(n, place.width, is_little_endian);
    }
    return value;
}

void Profile::Write(Bytes& bytes, std::size_t offset, const Place& place, std::uint64_t value) const noexcept {
    for (std::size_t n = 0; n < place.width; ++n) {
        bytes[offset + place.at + n] = static_cast<std::uint8_t>(value >> Shift(n, place.width, is_little_endian));
    }
}

std::uint64_t Profile::Checksum(ByteView bytes, std::size_t offset, std::uint32_t id) const noexcept {
    const std::size_t begin = offset + checksum.at;
    std::uint64_t found = crc(Ones(checksum.width), bytes.subspan(0, begin));
    found = crc(found, bytes.subspan(begin + checksum.width));
    if (data_id.width == 0) {
        const std::array<std::uint8_t, 2> own{
            static_cast<std::uint8_t>(id >> Shift(0, 2, is_little_endian)),
            static_cast<std::uint8_t>(id >> Shift(1, 2, is_little_endian))};
        return crc(found, ByteView{own.data(), own.size()});
    }
    return found ^ Ones(checksum.width);
}

const Profile* ProfileOf(std::uint8_t number) noexcept {
    switch (number) {
        case 4:
            return &kProfile4;
        case 5:
            return &kProfile5;
        case 6:
            return &kProfile6;
        case 7:
            return &kProfile7;
        default:
            return nullptr;
    }
}

}  // namespace bench
