// What an error code belongs to (SWS_CORE_00110).
#ifndef ARA_CORE_ERROR_DOMAIN_H_
#define ARA_CORE_ERROR_DOMAIN_H_

#include <cstdint>

namespace ara::core {

class ErrorCode;

class ErrorDomain {
public:
    using IdType = std::uint64_t;
    using CodeType = std::int32_t;
    using SupportDataType = std::int32_t;

    ErrorDomain(const ErrorDomain&) = delete;
    ErrorDomain& operator=(const ErrorDomain&) = delete;

    constexpr bool operator==(const ErrorDomain& other) const noexcept { return id_ == other.id_; }
    constexpr bool operator!=(const ErrorDomain& other) const noexcept { return id_ != other.id_; }

    constexpr IdType Id() const noexcept { return id_; }
    virtual const char* Name() const noexcept = 0;
    virtual const char* Message(CodeType code) const noexcept = 0;
    [[noreturn]] virtual void ThrowAsException(const ErrorCode& code) const noexcept(false) = 0;

protected:
    explicit constexpr ErrorDomain(IdType id) noexcept : id_{id} {}
    ~ErrorDomain() = default;

private:
    IdType id_;
};

}  // namespace ara::core

#endif  // ARA_CORE_ERROR_DOMAIN_H_
