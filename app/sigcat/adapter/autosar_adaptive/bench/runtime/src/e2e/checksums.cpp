#include "e2e/checksums.h"

#include <array>

namespace bench {
namespace {

constexpr std::uint16_t kPolynomial16 = 0x1021;
// With their bits in reverse, as these two take the lowest bit first.
constexpr std::uint32_t kReversed32 = 0xC8DF352F;          // of 0xF4ACFB13
constexpr std::uint64_t kReversed64 = 0xC96C5795D7870F42;  // of 0x42F0E1EBA9EA3693

template <typename T>
using Table = std::array<T, 256>;

constexpr Table<std::uint16_t> ForwardTable(std::uint16_t polynomial) {
    Table<std::uint16_t> table{};
    for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
        std::uint32_t rest = byte << 8;
        for (int bit = 0; bit < 8; ++bit) {
            rest = (rest & 0x8000U) != 0 ? (rest << 1) ^ polynomial : rest << 1;
        }
        table[byte] = static_cast<std::uint16_t>(rest);
    }
    return table;
}

template <typename T>
constexpr Table<T> ReversedTable(T polynomial) {
    Table<T> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte) {
        T rest = static_cast<T>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            rest = (rest & 1U) != 0 ? (rest >> 1) ^ polynomial : rest >> 1;
        }
        table[byte] = rest;
    }
    return table;
}

constexpr auto kTable16 = ForwardTable(kPolynomial16);
constexpr auto kTable32 = ReversedTable(kReversed32);
constexpr auto kTable64 = ReversedTable(kReversed64);

template <typename T>
std::uint64_t Reversed(const Table<T>& table, std::uint64_t checksum, ByteView bytes) noexcept {
    for (const std::uint8_t byte : bytes) {
        checksum = (checksum >> 8) ^ table[(checksum ^ byte) & 0xFFU];
    }
    return checksum;
}

}  // namespace

std::uint64_t Crc16(std::uint64_t checksum, ByteView bytes) noexcept {
    for (const std::uint8_t byte : bytes) {
        checksum = ((checksum << 8) & 0xFFFFU) ^ kTable16[((checksum >> 8) ^ byte) & 0xFFU];
    }
    return checksum;
}

std::uint64_t Crc32P4(std::uint64_t checksum, ByteView bytes) noexcept { return Reversed(kTable32, checksum, bytes); }

std::uint64_t Crc64(std::uint64_t checksum, ByteView bytes) noexcept { return Reversed(kTable64, checksum, bytes); }

}  // namespace bench
