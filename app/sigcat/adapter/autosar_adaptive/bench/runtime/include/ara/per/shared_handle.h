// What several parts of a process hold together (SWS_PER_00362).
#ifndef ARA_PER_SHARED_HANDLE_H_
#define ARA_PER_SHARED_HANDLE_H_

#include <memory>

namespace ara::per {

template <typename T>
using SharedHandle = std::shared_ptr<T>;

}  // namespace ara::per

#endif  // ARA_PER_SHARED_HANDLE_H_
