// A text of another owner (SWS_CORE_02001).
#ifndef ARA_CORE_STRING_VIEW_H_
#define ARA_CORE_STRING_VIEW_H_

#include <string_view>

namespace ara::core {

using StringView = std::string_view;

}  // namespace ara::core

#endif  // ARA_CORE_STRING_VIEW_H_
