// Values by key (SWS_CORE_01400).
#ifndef ARA_CORE_MAP_H_
#define ARA_CORE_MAP_H_

#include <map>

namespace ara::core {

template <typename K, typename V>
using Map = std::map<K, V>;

}  // namespace ara::core

#endif  // ARA_CORE_MAP_H_
