// Errors of execution management (SWS_EM_02284).
#ifndef ARA_EXEC_EXEC_ERROR_DOMAIN_H_
#define ARA_EXEC_EXEC_ERROR_DOMAIN_H_

#include "ara/core/error_code.h"
#include "ara/core/exception.h"

namespace ara::exec {

enum class ExecErrc : ara::core::ErrorDomain::CodeType {
    kGeneralError = 1,
    kInvalidArgument = 2,
    kCommunicationError = 3,
    kInvalidTransition = 5,
};

class ExecException : public ara::core::Exception {
public:
    using ara::core::Exception::Exception;
};

class ExecErrorDomain final : public ara::core::ErrorDomain {
public:
    using Errc = ExecErrc;
    using Exception = ExecException;

    constexpr ExecErrorDomain() noexcept : ErrorDomain{0x8000000000000202} {}
    const char* Name() const noexcept override { return "Exec"; }
    const char* Message(CodeType code) const noexcept override;
    [[noreturn]] void ThrowAsException(const ara::core::ErrorCode& code) const noexcept(false) override {
        throw ExecException{code};
    }
};

const ara::core::ErrorDomain& GetExecErrorDomain() noexcept;

inline ara::core::ErrorCode MakeErrorCode(ExecErrc code, ara::core::ErrorDomain::SupportDataType data) noexcept {
    return {static_cast<ara::core::ErrorDomain::CodeType>(code), GetExecErrorDomain(), data};
}

}  // namespace ara::exec

#endif  // ARA_EXEC_EXEC_ERROR_DOMAIN_H_
