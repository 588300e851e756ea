#include "ara/core/initialization.h"

#include "ara/com/com_error_domain.h"
#include "services/runtime.h"

namespace ara::core {

Result<void> Initialize() noexcept {
    if (!bench::Runtime::Get().Start()) {
        return Result<void>::FromError(ara::com::ComErrc::kNetworkBindingFailure);
    }
    return {};
}

Result<void> Deinitialize() noexcept {
    bench::Runtime::Get().Stop();
    return {};
}

}  // namespace ara::core
