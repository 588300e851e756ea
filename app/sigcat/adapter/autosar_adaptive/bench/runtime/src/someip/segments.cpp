#include "someip/segments.h"

#include <algorithm>

#include "someip/big_endian.h"

namespace bench {
namespace {

constexpr std::size_t kStep = 16;                 // offsets are counted in these
constexpr std::size_t kSegmentLength = 1392;      // of a payload: the largest multiple of it that fits
constexpr std::size_t kLongestMessage = 1 << 20;  // messages of others must not take all memory
constexpr std::size_t kMostBegun = 64;

Bytes WrittenSegment(const Header& header, ByteView payload, std::size_t offset) {
    const std::size_t length = std::min(kSegmentLength, payload.size() - offset);
    const bool has_more = offset + length < payload.size();
    Bytes bytes;
    bytes.reserve(4 + length);
    Append(bytes, static_cast<std::uint32_t>(offset) | (has_more ? 1U : 0U), 4);
    bytes.insert(bytes.end(), payload.begin() + offset, payload.begin() + offset + length);
    return Written(header, bytes);
}

}  // namespace

std::vector<Bytes> Datagrams(const Header& header, ByteView payload) {
    if (payload.size() <= kLongestPayload) {
        return {Written(header, payload)};
    }
    Header segment = header;
    segment.type = static_cast<std::uint8_t>(header.type | kSegment);
    std::vector<Bytes> datagrams;
    for (std::size_t offset = 0; offset < payload.size(); offset += kSegmentLength) {
        datagrams.push_back(WrittenSegment(segment, payload, offset));
    }
    return datagrams;
}

std::optional<Bytes> Reassembly::Add(const Message& segment, const Endpoint& from) {
    if (segment.payload.size() < 4) {
        return std::nullopt;
    }
    const std::uint32_t word = NumberAt(segment.payload, 0, 4);
    const std::size_t offset = word & ~static_cast<std::uint32_t>(kStep - 1);
    const bool has_more = (word & 1U) != 0;
    const ByteView part = segment.payload.subspan(4);
    const Key key{from, segment.header.service, segment.header.method, segment.header.client};
    if (offset == 0) {
        if (begun_.size() >= kMostBegun) {
            begun_.clear();
        }
        begun_[key] = Begun{segment.header.session, {}};
    }
    const auto found = begun_.find(key);
    if (found == begun_.end()) {
        return std::nullopt;
    }
    auto& [session, payload] = found->second;
    const bool fits = session == segment.header.session && offset == payload.size() &&
                      payload.size() + part.size() <= kLongestMessage && (!has_more || part.size() % kStep == 0);
    if (!fits) {
        begun_.erase(found);
        return std::nullopt;
    }
    payload.insert(payload.end(), part.begin(), part.end());
    if (has_more) {
        return std::nullopt;
    }
    Bytes whole = std::move(payload);
    begun_.erase(found);
    return whole;
}

}  // namespace bench
