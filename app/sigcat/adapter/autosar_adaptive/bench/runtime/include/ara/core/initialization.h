// Start and end of the parts of ara that a process uses (SWS_CORE_10001, SWS_CORE_10002).
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
