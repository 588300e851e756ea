// Types of communication that do not depend on a service (SWS_CM_01018).
#ifndef ARA_COM_TYPES_H_
#define ARA_COM_TYPES_H_

#include <cstdint>
#include <functional>

#include "ara/com/instance_identifier.h"
#include "ara/com/sample_allocatee_ptr.h"
#include "ara/com/sample_ptr.h"
#include "ara/core/vector.h"

namespace ara::com {

enum class MethodCallProcessingMode : std::uint8_t { kPoll, kEvent, kEventSingleThread };

enum class SubscriptionState : std::uint8_t { kSubscribed, kNotSubscribed, kSubscriptionPending };

using InstanceIdentifierContainer = ara::core::Vector<InstanceIdentifier>;

// Of one search; the search itself ends with StopFindService.
class FindServiceHandle final {
public:
    explicit FindServiceHandle(std::uint64_t search) noexcept : search_{search} {}

    bool operator==(const FindServiceHandle& other) const noexcept { return search_ == other.search_; }
    bool operator<(const FindServiceHandle& other) const noexcept { return search_ < other.search_; }
    std::uint64_t Search() const noexcept { return search_; }

private:
    std::uint64_t search_;
};

template <typename HandleType>
using ServiceHandleContainer = ara::core::Vector<HandleType>;

template <typename HandleType>
using FindServiceHandler = std::function<void(ServiceHandleContainer<HandleType>, FindServiceHandle)>;

using EventReceiveHandler = std::function<void()>;
using SubscriptionStateChangeHandler = std::function<void(SubscriptionState)>;

}  // namespace ara::com

#endif  // ARA_COM_TYPES_H_
