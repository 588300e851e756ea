// What is thrown where a value is taken of a result that has none (SWS_CORE_00601).
#ifndef ARA_CORE_EXCEPTION_H_
#define ARA_CORE_EXCEPTION_H_

#include <exception>

#include "ara/core/error_code.h"

namespace ara::core {

class Exception : public std::exception {
public:
    explicit Exception(ErrorCode error) noexcept : error_{error} {}

    const ErrorCode& Error() const noexcept { return error_; }
    const char* what() const noexcept override { return error_.Message(); }

private:
    ErrorCode error_;
};

}  // namespace ara::core

#endif  // ARA_CORE_EXCEPTION_H_
