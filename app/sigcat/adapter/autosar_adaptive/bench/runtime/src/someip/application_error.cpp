#include "someip/application_error.h"

#include <algorithm>

#include "someip/big_endian.h"

namespace bench {
namespace {

constexpr std::uint32_t kStructLength = 12;  // of domain and code
constexpr std::uint32_t kUnionLength = kStructLength + 2;
constexpr std::uint32_t kTypeOfError = 1;
constexpr std::size_t kPayloadLength = 4 + 1 + kUnionLength;
constexpr std::uint8_t kCodesOfServices = 0x1F;  // return codes beyond are errors of a service of AUTOSAR Classic

// The one error that is so; none if there are several.
template <typename Is>
std::optional<ara::core::ErrorCode> OnlyError(const ServiceDescription& service, Is is) {
    const auto found = std::find_if(service.errors.begin(), service.errors.end(), is);
    if (found == service.errors.end() || std::find_if(found + 1, service.errors.end(), is) != service.errors.end()) {
        return std::nullopt;
    }
    return ara::core::ErrorCode{found->code, *found->domain};
}

}  // namespace

bool IsModelled(const ara::core::ErrorCode& error, const ServiceDescription& service) noexcept {
    return std::any_of(service.errors.begin(), service.errors.end(), [&error](const ErrorDescription& each) {
        return *each.domain == error.Domain() && each.code == error.Value();
    });
}

Bytes WrittenError(const ara::core::ErrorCode& error) {
    const std::uint64_t domain = error.Domain().Id();
    Bytes payload;
    Append(payload, kUnionLength, 4);
    Append(payload, kTypeOfError, 1);
    Append(payload, kStructLength, 2);
    Append(payload, static_cast<std::uint32_t>(domain >> 32U), 4);
    Append(payload, static_cast<std::uint32_t>(domain), 4);
    Append(payload, static_cast<std::uint32_t>(error.Value()), 4);
    return payload;
}

std::optional<ara::core::ErrorCode> ReadError(const Message& answer, const ServiceDescription& service) {
    const auto code = static_cast<std::uint8_t>(answer.header.code);
    if (answer.header.Is(MessageType::kResponse)) {  // SWS_CM_10358
        return OnlyError(service, [code](const ErrorDescription& each) { return each.code == code - kCodesOfServices; });
    }
    const ByteView payload = answer.payload;
    if (answer.header.code != ReturnCode::kNotOk || payload.size() != kPayloadLength ||
        NumberAt(payload, 0, 4) != kUnionLength || NumberAt(payload, 4, 1) != kTypeOfError ||
        NumberAt(payload, 5, 2) != kStructLength) {
        return std::nullopt;
    }
    const std::uint64_t domain = (std::uint64_t{NumberAt(payload, 7, 4)} << 32U) | NumberAt(payload, 11, 4);
    const auto value = static_cast<ara::core::ErrorDomain::CodeType>(NumberAt(payload, 15, 4));
    return OnlyError(service, [domain, value](const ErrorDescription& each) {
        return each.domain->Id() == domain && each.code == value;
    });
}

}  // namespace bench
