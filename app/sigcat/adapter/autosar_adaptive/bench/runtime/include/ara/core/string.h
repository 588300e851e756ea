// A text (SWS_CORE_03001).
#ifndef ARA_CORE_STRING_H_
#define ARA_CORE_STRING_H_

#include <string>

namespace ara::core {

using String = std::string;

}  // namespace ara::core

#endif  // ARA_CORE_STRING_H_
