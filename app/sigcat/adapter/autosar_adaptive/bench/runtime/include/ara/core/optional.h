// A value, or none (SWS_CORE_01030).
#ifndef ARA_CORE_OPTIONAL_H_
#define ARA_CORE_OPTIONAL_H_

#include <optional>

namespace ara::core {

template <typename T>
using Optional = std::optional<T>;
using std::nullopt;

}  // namespace ara::core

#endif  // ARA_CORE_OPTIONAL_H_
