#include "ara/com/instance_identifier.h"

#include <charconv>
#include <optional>

#include "ara/com/com_error_domain.h"

namespace ara::com {
namespace {

constexpr std::string_view kStart = "SOME/IP:";

struct Ids {
    std::uint16_t service;
    std::uint16_t instance;
};

std::optional<Ids> Parsed(std::string_view text) {
    if (text.substr(0, kStart.size()) != kStart) {
        return std::nullopt;
    }
    Ids ids{};
    const char* const end = text.data() + text.size();
    const auto service = std::from_chars(text.data() + kStart.size(), end, ids.service);
    if (service.ec != std::errc{} || service.ptr == end || *service.ptr != ':') {
        return std::nullopt;
    }
    const auto instance = std::from_chars(service.ptr + 1, end, ids.instance);
    if (instance.ec != std::errc{} || instance.ptr != end) {
        return std::nullopt;
    }
    return ids;
}

}  // namespace

InstanceIdentifier::InstanceIdentifier(std::string_view text) : text_{text} {
    const auto ids = Parsed(text);
    if (!ids.has_value()) {
        ara::core::ErrorCode{ComErrc::kInvalidInstanceIdentifierString}.ThrowAsException();
    }
    service_ = ids->service;
    instance_ = ids->instance;
}

ara::core::Result<InstanceIdentifier> InstanceIdentifier::Create(std::string_view text) {
    if (!Parsed(text).has_value()) {
        return ara::core::Result<InstanceIdentifier>::FromError(ComErrc::kInvalidInstanceIdentifierString);
    }
    return InstanceIdentifier{text};
}

}  // namespace ara::com
