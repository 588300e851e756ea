// A number with the domain that knows what it means (SWS_CORE_00501).
#ifndef ARA_CORE_ERROR_CODE_H_
#define ARA_CORE_ERROR_CODE_H_

#include <exception>
#include <type_traits>

#include "ara/core/error_domain.h"

namespace ara::core {

class ErrorCode final {
public:
    // Of an enumeration for which its namespace has `MakeErrorCode`.
    template <typename EnumT, typename = std::enable_if_t<std::is_enum_v<EnumT>>>
    constexpr ErrorCode(EnumT e, ErrorDomain::SupportDataType data = 0) noexcept
        : ErrorCode{MakeErrorCode(e, data)} {}

    constexpr ErrorCode(ErrorDomain::CodeType value, const ErrorDomain& domain,
                        ErrorDomain::SupportDataType data = 0) noexcept
        : value_{value}, data_{data}, domain_{&domain} {}

    constexpr ErrorDomain::CodeType Value() const noexcept { return value_; }
    constexpr const ErrorDomain& Domain() const noexcept { return *domain_; }
    constexpr ErrorDomain::SupportDataType SupportData() const noexcept { return data_; }
    const char* Message() const noexcept { return domain_->Message(value_); }
    [[noreturn]] void ThrowAsException() const {
        domain_->ThrowAsException(*this);
        std::terminate();  // for compilers that do not know that the domain throws
    }

private:
    ErrorDomain::CodeType value_;
    ErrorDomain::SupportDataType data_;
    const ErrorDomain* domain_;
};

constexpr bool operator==(const ErrorCode& left, const ErrorCode& right) noexcept {
    return left.Value() == right.Value() && left.Domain() == right.Domain();
}

constexpr bool operator!=(const ErrorCode& left, const ErrorCode& right) noexcept { return !(left == right); }

}  // namespace ara::core

#endif  // ARA_CORE_ERROR_CODE_H_
