// Texts of the errors of ara::com.
#include "ara/com/com_error_domain.h"

namespace ara::com {

const char* ComErrorDomain::Message(CodeType code) const noexcept {
    switch (static_cast<ComErrc>(code)) {
        case ComErrc::kServiceNotAvailable:
            return "The service is not available.";
        case ComErrc::kMaxSamplesExceeded:
            return "All samples of the subscription are held.";
        case ComErrc::kNetworkBindingFailure:
            return "The network cannot be used.";
        case ComErrc::kGrantEnforcementError:
            return "The access is not granted.";
        case ComErrc::kPeerIsUnreachable:
            return "The other side cannot be reached.";
        case ComErrc::kFieldValueIsNotValid:
            return "A field has no value yet.";
        case ComErrc::kSetHandlerNotSet:
            return "A field that can be set has no handler for that.";
        case ComErrc::kUnsetFailure:
            return "The handler cannot be unset.";
        case ComErrc::kSampleAllocationFailure:
            return "No memory for a sample.";
        case ComErrc::kIllegalUseOfAllocate:
            return "The sample was not allocated.";
        case ComErrc::kServiceNotOffered:
            return "The service is not offered.";
        case ComErrc::kCommunicationLinkError:
            return "The link is broken.";
        case ComErrc::kNoClients:
            return "Nobody has subscribed.";
        case ComErrc::kCommunicationStackError:
            return "The other side answered with an error.";
        case ComErrc::kMaxSampleCountNotRealizable:
            return "The number of samples is not possible.";
        case ComErrc::kWrongMethodCallProcessingMode:
            return "Methods are not processed in this mode.";
        case ComErrc::kErroneousFileHandle:
            return "The file cannot be used.";
        case ComErrc::kCouldNotExecute:
            return "The executor did not run it.";
        case ComErrc::kInvalidInstanceIdentifierString:
            return "The text is not an instance identifier.";
        case ComErrc::kInstanceIDNotResolvable:
            return "The port is of no instance of the service.";
    }
    return "Unknown error of ara::com.";
}

const ara::core::ErrorDomain& GetComErrorDomain() noexcept {
    static constexpr ComErrorDomain domain;
    return domain;
}

}  // namespace ara::com
