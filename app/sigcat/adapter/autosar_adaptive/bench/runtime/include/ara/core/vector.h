// An array of open length (SWS_CORE_01301).
#ifndef ARA_CORE_VECTOR_H_
#define ARA_CORE_VECTOR_H_

#include <vector>

namespace ara::core {

template <typename T>
using Vector = std::vector<T>;

}  // namespace ara::core

#endif  // ARA_CORE_VECTOR_H_
