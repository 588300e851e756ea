#include "ara/core/instance_specifier.h"

#include <algorithm>

#include "ara/core/core_error_domain.h"

namespace ara::core {
namespace {

bool IsInName(char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
           (character >= '0' && character <= '9') || character == '_';
}

// Short names with one slash between each two.
bool IsPath(std::string_view path) {
    const bool has_ends = !path.empty() && path.front() != '/' && path.back() != '/';
    const bool has_names = std::all_of(path.begin(), path.end(), [](char c) { return c == '/' || IsInName(c); });
    return has_ends && has_names && path.find("//") == std::string_view::npos;
}

}  // namespace

InstanceSpecifier::InstanceSpecifier(std::string_view path) : path_{path} {
    if (!IsPath(path)) {
        ErrorCode{CoreErrc::kInvalidMetaModelPath}.ThrowAsException();
    }
}

Result<InstanceSpecifier> InstanceSpecifier::Create(std::string_view path) {
    if (!IsPath(path)) {
        return Result<InstanceSpecifier>::FromError(CoreErrc::kInvalidMetaModelPath);
    }
    return InstanceSpecifier{path};
}

}  // namespace ara::core
