// What cells know of AUTOSAR's arrays: that they are those of the standard library.

#ifndef ARA_CORE_ARRAY_H
#define ARA_CORE_ARRAY_H

#include <array>

namespace ara::core {

template <typename T, std::size_t size>
using Array = std::array<T, size>;

}  // namespace ara::core

#endif  // ARA_CORE_ARRAY_H
