// Errors of persistency (SWS_PER_00311).
#ifndef ARA_PER_PER_ERROR_DOMAIN_H_
#define ARA_PER_PER_ERROR_DOMAIN_H_

#include "ara/core/error_code.h"
#include "ara/core/exception.h"

namespace ara::per {

enum class PerErrc : ara::core::ErrorDomain::CodeType {
    kStorageNotFound = 1,
    kKeyNotFound = 2,
    kIllegalWriteAccess = 3,
    kPhysicalStorageFailure = 4,
    kIntegrityCorrupted = 5,
    kDataTypeMismatch = 8,
};

class PerException : public ara::core::Exception {
public:
    using ara::core::Exception::Exception;
};

class PerErrorDomain final : public ara::core::ErrorDomain {
public:
    using Errc = PerErrc;
    using Exception = PerException;

    constexpr PerErrorDomain() noexcept : ErrorDomain{0x8000000000000101} {}
    const char* Name() const noexcept override { return "Per"; }
    const char* Message(CodeType code) const noexcept override;
    [[noreturn]] void ThrowAsException(const ara::core::ErrorCode& code) const noexcept(false) override {
        throw PerException{code};
    }
};

const ara::core::ErrorDomain& GetPerErrorDomain() noexcept;

inline ara::core::ErrorCode MakeErrorCode(PerErrc code, ara::core::ErrorDomain::SupportDataType data) noexcept {
    return {static_cast<ara::core::ErrorDomain::CodeType>(code), GetPerErrorDomain(), data};
}

}  // namespace ara::per

#endif  // ARA_PER_PER_ERROR_DOMAIN_H_
