// How the profiles of end-to-end protection lay out their headers (PRS_E2EProtocol, sections of profiles 4, 5, 6 and 7).
#ifndef BENCH_E2E_PROFILES_H_
#define BENCH_E2E_PROFILES_H_

#include <cstdint>

#include "bench/codec.h"

namespace bench {

// Place of a number in the header; of width 0 it is absent.
struct Place {
    std::size_t at;
    std::size_t width;
};

struct Profile {
    std::size_t header;  // bytes
    Place checksum;
    Place length;
    Place counter;
    Place data_id;  // where it is not sent, the checksum goes over it, as over two more bytes
    bool is_little_endian;
    std::uint64_t (*crc)(std::uint64_t, ByteView) noexcept;

    std::uint64_t LastCounter() const noexcept { return (std::uint64_t{1} << (8 * counter.width)) - 1; }
    std::uint64_t Read(ByteView header_bytes, const Place& place) const noexcept;
    void Write(Bytes& bytes, std::size_t offset, const Place& place, std::uint64_t value) const noexcept;
    // Over all bytes but those of the checksum itself; the header is at `offset`.
    std::uint64_t Checksum(ByteView bytes, std::size_t offset, std::uint32_t id) const noexcept;
};

// None has this number: nullptr.
const Profile* ProfileOf(std::uint8_t number) noexcept;

}  // namespace bench

#endif  // BENCH_E2E_PROFILES_H_
