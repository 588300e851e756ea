#include "e2e/protection.h"

#include "e2e/profiles.h"
#include "someip/big_endian.h"

namespace bench {
namespace {

using ara::com::e2e::ProfileCheckStatus;

constexpr std::size_t kOffset = 8;  // bytes before the header of the profile

// The part of the header that is protected, and room for what follows.
Bytes Beginning(const Header& header, std::size_t following) {
    Bytes bytes;
    bytes.reserve(kOffset + following);
    Append(bytes, header.client, 2);
    Append(bytes, header.session, 2);
    Append(bytes, header.protocol_version, 1);
    Append(bytes, header.interface_version, 1);
    Append(bytes, header.type, 1);
    Append(bytes, static_cast<std::uint32_t>(header.code), 1);
    return bytes;
}

}  // namespace

Bytes Protected(const Protection& protection, std::uint32_t& counter, const Header& header, ByteView values) {
    const Profile* const profile = ProfileOf(protection.profile);
    if (profile == nullptr) {
        return {values.begin(), values.end()};
    }
    Bytes bytes = Beginning(header, profile->header + values.size());
    bytes.resize(kOffset + profile->header);
    bytes.insert(bytes.end(), values.begin(), values.end());
    profile->Write(bytes, kOffset, profile->length, bytes.size());
    profile->Write(bytes, kOffset, profile->counter, counter);
    profile->Write(bytes, kOffset, profile->data_id, protection.data_id);
    profile->Write(bytes, kOffset, profile->checksum, profile->Checksum(bytes, kOffset, protection.data_id));
    counter = counter == profile->LastCounter() ? 0 : counter + 1;
    return {bytes.begin() + kOffset, bytes.end()};
}

ByteView Values(const Protection& protection, ByteView payload) noexcept {
    const Profile* const profile = ProfileOf(protection.profile);
    if (profile == nullptr) {
        return payload;
    }
    return payload.size() < profile->header ? ByteView{} : payload.subspan(profile->header);
}

Checker::Checker(const Protection& protection) noexcept : protection_{protection}, counter_{0} {
    if (const Profile* const profile = ProfileOf(protection.profile); profile != nullptr) {
        counter_ = profile->LastCounter();  // so that the first message of a sender that begins is the next one
    }
}

ProfileCheckStatus Checker::Check(const Header& header, ByteView payload) {
    const Profile* const profile = ProfileOf(protection_.profile);
    if (profile == nullptr) {
        return ProfileCheckStatus::kCheckDisabled;
    }
    if (!IsWhole(header, payload)) {
        return ProfileCheckStatus::kError;
    }
    const std::uint64_t counter = profile->Read(payload, profile->counter);
    const std::uint64_t step = (counter - counter_) & profile->LastCounter();
    counter_ = counter;
    if (step == 0) {
        return ProfileCheckStatus::kRepeated;
    }
    return step > protection_.max_delta_counter ? ProfileCheckStatus::kWrongSequence : ProfileCheckStatus::kOk;
}

bool Checker::IsWhole(const Header& header, ByteView payload) const {
    const Profile& profile = *ProfileOf(protection_.profile);
    if (payload.size() < profile.header) {
        return false;
    }
    Bytes bytes = Beginning(header, payload.size());
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    const bool has_length = profile.length.width > 0;
    const bool has_id = profile.data_id.width > 0;
    return profile.Read(payload, profile.checksum) == profile.Checksum(bytes, kOffset, protection_.data_id) &&
           (!has_length || profile.Read(payload, profile.length) == bytes.size()) &&
           (!has_id || profile.Read(payload, profile.data_id) == protection_.data_id);
}

}  // namespace bench
