// Application errors of methods, as answers have them.
#ifndef BENCH_SOMEIP_APPLICATION_ERROR_H_
#define BENCH_SOMEIP_APPLICATION_ERROR_H_

#include <optional>

#include "ara/core/error_code.h"
#include "bench/description.h"
#include "someip/message.h"

namespace bench {

// Whether methods of the service may return it.
bool IsModelled(const ara::core::ErrorCode& error, const ServiceDescription& service) noexcept;

// The payload: a union with a struct of the id of the domain and the code (SWS_CM_10428).
Bytes WrittenError(const ara::core::ErrorCode& error);

// The error of an answer; none if the service does not have it.
std::optional<ara::core::ErrorCode> ReadError(const Message& answer, const ServiceDescription& service);

}  // namespace bench

#endif  // BENCH_SOMEIP_APPLICATION_ERROR_H_
