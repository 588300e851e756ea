// Texts of the errors of ara::core.
#include "ara/core/core_error_domain.h"
#include "ara/core/future_error_domain.h"

namespace ara::core {

const char* CoreErrorDomain::Message(CodeType code) const noexcept {
    switch (static_cast<CoreErrc>(code)) {
        case CoreErrc::kInvalidArgument:
            return "An argument is not valid.";
        case CoreErrc::kInvalidMetaModelShortname:
            return "A short name is not valid.";
        case CoreErrc::kInvalidMetaModelPath:
            return "A path of short names is missing or not valid.";
    }
    return "Unknown error of ara::core.";
}

const ErrorDomain& GetCoreErrorDomain() noexcept {
    static constexpr CoreErrorDomain domain;
    return domain;
}

const char* FutureErrorDomain::Message(CodeType code) const noexcept {
    switch (static_cast<future_errc>(code)) {
        case future_errc::broken_promise:
            return "The promise ended without a value.";
        case future_errc::future_already_retrieved:
            return "The future was already taken.";
        case future_errc::promise_already_satisfied:
            return "The promise has a value already.";
        case future_errc::no_state:
            return "The future is of no promise.";
    }
    return "Unknown error of a future.";
}

const ErrorDomain& GetFutureErrorDomain() noexcept {
    static constexpr FutureErrorDomain domain;
    return domain;
}

}  // namespace ara::core
