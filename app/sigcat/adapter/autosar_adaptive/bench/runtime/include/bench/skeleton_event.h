// Event of a skeleton (SWS_CM_00003).
#ifndef BENCH_SKELETON_EVENT_H_
#define BENCH_SKELETON_EVENT_H_

#include <memory>

#include "ara/com/com_error_domain.h"
#include "bench/skeleton_connection.h"

namespace bench {

template <typename T>
class SkeletonEvent {
public:
    using SampleType = T;

    SkeletonEvent(const std::shared_ptr<SkeletonConnection>& connection, const EventDescription& event) noexcept
        : connection_{connection}, event_{&event} {}

    ara::core::Result<ara::com::SampleAllocateePtr<T>> Allocate() { return {std::make_unique<T>()}; }

    ara::core::Result<void> Send(const T& data) {
        Writer writer{connection_->Service().serialization};
        Codec<T>::Write(writer, data);
        return connection_->Send(*event_, writer);
    }

    ara::core::Result<void> Send(ara::com::SampleAllocateePtr<T> data) {
        if (data == nullptr) {
            return ara::core::Result<void>::FromError(ara::com::ComErrc::kIllegalUseOfAllocate);
        }
        return Send(*data);
    }

private:
    std::shared_ptr<SkeletonConnection> connection_;
    const EventDescription* event_;
};

}  // namespace bench

#endif  // BENCH_SKELETON_EVENT_H_
