// Errors of futures and promises (SWS_CORE_00400).
#ifndef ARA_CORE_FUTURE_ERROR_DOMAIN_H_
#define ARA_CORE_FUTURE_ERROR_DOMAIN_H_

#include "ara/core/error_code.h"
#include "ara/core/exception.h"

namespace ara::core {

enum class future_errc : ErrorDomain::CodeType {
    broken_promise = 101,
    future_already_retrieved = 102,
    promise_already_satisfied = 103,
    no_state = 104,
};

class FutureException : public Exception {
public:
    using Exception::Exception;
};

class FutureErrorDomain final : public ErrorDomain {
public:
    using Errc = future_errc;
    using Exception = FutureException;

    constexpr FutureErrorDomain() noexcept : ErrorDomain{0x8000000000000013} {}
    const char* Name() const noexcept override { return "Future"; }
    const char* Message(CodeType code) const noexcept override;
    [[noreturn]] void ThrowAsException(const ErrorCode& code) const noexcept(false) override {
        throw FutureException{code};
    }
};

const ErrorDomain& GetFutureErrorDomain() noexcept;

inline ErrorCode MakeErrorCode(future_errc code, ErrorDomain::SupportDataType data) noexcept {
    return {static_cast<ErrorDomain::CodeType>(code), GetFutureErrorDomain(), data};
}

}  // namespace ara::core

#endif  // ARA_CORE_FUTURE_ERROR_DOMAIN_H_
