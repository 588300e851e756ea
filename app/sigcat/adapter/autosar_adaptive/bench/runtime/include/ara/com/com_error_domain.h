// Errors of communication (SWS_CM_10432).
#ifndef ARA_COM_COM_ERROR_DOMAIN_H_
#define ARA_COM_COM_ERROR_DOMAIN_H_

#include "ara/core/error_code.h"
#include "ara/core/exception.h"

namespace ara::com {

enum class ComErrc : ara::core::ErrorDomain::CodeType {
    kServiceNotAvailable = 1,
    kMaxSamplesExceeded = 2,
    kNetworkBindingFailure = 3,
    kGrantEnforcementError = 4,
    kPeerIsUnreachable = 5,
    kFieldValueIsNotValid = 6,
    kSetHandlerNotSet = 7,
    kUnsetFailure = 8,
    kSampleAllocationFailure = 9,
    kIllegalUseOfAllocate = 10,
    kServiceNotOffered = 11,
    kCommunicationLinkError = 12,
    kNoClients = 13,
    kCommunicationStackError = 14,
    kMaxSampleCountNotRealizable = 15,
    kWrongMethodCallProcessingMode = 16,
    kErroneousFileHandle = 17,
    kCouldNotExecute = 18,
    kInvalidInstanceIdentifierString = 19,
    kInstanceIDNotResolvable = 20,
};

class ComException : public ara::core::Exception {
public:
    using ara::core::Exception::Exception;
};

class ComErrorDomain final : public ara::core::ErrorDomain {
public:
    using Errc = ComErrc;
    using Exception = ComException;

    constexpr ComErrorDomain() noexcept : ErrorDomain{0x8000000000001267} {}
    const char* Name() const noexcept override { return "Com"; }
    const char* Message(CodeType code) const noexcept override;
    [[noreturn]] void ThrowAsException(const ara::core::ErrorCode& code) const noexcept(false) override {
        throw ComException{code};
    }
};

const ara::core::ErrorDomain& GetComErrorDomain() noexcept;

inline ara::core::ErrorCode MakeErrorCode(ComErrc code, ara::core::ErrorDomain::SupportDataType data) noexcept {
    return {static_cast<ara::core::ErrorDomain::CodeType>(code), GetComErrorDomain(), data};
}

}  // namespace ara::com

#endif  // ARA_COM_COM_ERROR_DOMAIN_H_
