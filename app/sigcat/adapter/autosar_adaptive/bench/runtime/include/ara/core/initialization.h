// Start and end of what a process uses of ara (SWS_CORE_10001, SWS_CORE_10002).
#ifndef ARA_CORE_INITIALIZATION_H_
#define ARA_CORE_INITIALIZATION_H_

#include "ara/core/result.h"

namespace ara::core {

// Once, before any other call. Opens the sockets of the process; an error says that its address cannot be used.
Result<void> Initialize() noexcept;

// At the end. Whatever is still offered is no longer, and no handler runs afterwards.
Result<void> Deinitialize() noexcept;

}  // namespace ara::core

#endif  // ARA_CORE_INITIALIZATION_H_
