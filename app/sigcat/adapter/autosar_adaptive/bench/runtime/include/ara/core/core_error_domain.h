// Errors of ara::core itself (SWS_CORE_05200).
#ifndef ARA_CORE_CORE_ERROR_DOMAIN_H_
#define ARA_CORE_CORE_ERROR_DOMAIN_H_

#include "ara/core/error_code.h"
#include "ara/core/exception.h"

namespace ara::core {

enum class CoreErrc : ErrorDomain::CodeType {
    kInvalidArgument = 22,
    kInvalidMetaModelShortname = 137,
    kInvalidMetaModelPath = 138,
};

class CoreException : public Exception {
public:
    using Exception::Exception;
};

class CoreErrorDomain final : public ErrorDomain {
public:
    using Errc = CoreErrc;
    using Exception = CoreException;

    constexpr CoreErrorDomain() noexcept : ErrorDomain{0x8000000000000014} {}
    const char* Name() const noexcept override { return "Core"; }
    const char* Message(CodeType code) const noexcept override;
    [[noreturn]] void ThrowAsException(const ErrorCode& code) const noexcept(false) override {
        throw CoreException{code};
    }
};

const ErrorDomain& GetCoreErrorDomain() noexcept;

inline ErrorCode MakeErrorCode(CoreErrc code, ErrorDomain::SupportDataType data) noexcept {
    return {static_cast<ErrorDomain::CodeType>(code), GetCoreErrorDomain(), data};
}

}  // namespace ara::core

#endif  // ARA_CORE_CORE_ERROR_DOMAIN_H_
