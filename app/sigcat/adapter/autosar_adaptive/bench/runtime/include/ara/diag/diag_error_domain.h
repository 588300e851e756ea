// Errors of diagnosis (SWS_DM_00514).
#ifndef ARA_DIAG_DIAG_ERROR_DOMAIN_H_
#define ARA_DIAG_DIAG_ERROR_DOMAIN_H_

#include "ara/core/error_code.h"
#include "ara/core/exception.h"

namespace ara::diag {

enum class DiagErrc : ara::core::ErrorDomain::CodeType {
    kAlreadyOffered = 101,
    kConfigurationMismatch = 102,
    kDebouncingConfigurationInconsistent = 103,
    kReportIgnored = 104,
    kInvalidArgument = 105,
    kNotOffered = 106,
    kGenericError = 107,
};

class DiagException : public ara::core::Exception {
public:
    using ara::core::Exception::Exception;
};

class DiagErrorDomain final : public ara::core::ErrorDomain {
public:
    using Errc = DiagErrc;
    using Exception = DiagException;

    constexpr DiagErrorDomain() noexcept : ErrorDomain{0x8000000000000401} {}
    const char* Name() const noexcept override { return "Diag"; }
    const char* Message(CodeType code) const noexcept override;
    [[noreturn]] void ThrowAsException(const ara::core::ErrorCode& code) const noexcept(false) override {
        throw DiagException{code};
    }
};

const ara::core::ErrorDomain& GetDiagErrorDomain() noexcept;

inline ara::core::ErrorCode MakeErrorCode(DiagErrc code, ara::core::ErrorDomain::SupportDataType data) noexcept {
    return {static_cast<ara::core::ErrorDomain::CodeType>(code), GetDiagErrorDomain(), data};
}

}  // namespace ara::diag

#endif  // ARA_DIAG_DIAG_ERROR_DOMAIN_H_
