// What every skeleton has, whatever its service.
#ifndef BENCH_SKELETON_BASE_H_
#define BENCH_SKELETON_BASE_H_

#include <memory>

#include "bench/skeleton_connection.h"

namespace bench {

template <const ServiceDescription& Service>
class SkeletonBase {
public:
    ara::core::Result<void> OfferService() { return connection_->OfferService(); }
    void StopOfferService() { connection_->StopOfferService(); }
    ara::core::Future<bool> ProcessNextMethodCall() { return connection_->ProcessNextMethodCall(); }

protected:
    template <typename Instance>
    SkeletonBase(const Instance& instance, ara::com::MethodCallProcessingMode mode)
        : connection_{std::make_shared<SkeletonConnection>(Service, instance, mode)} {}
    SkeletonBase(SkeletonBase&&) noexcept = default;
    SkeletonBase& operator=(SkeletonBase&&) noexcept = default;
    ~SkeletonBase() = default;

    std::shared_ptr<SkeletonConnection> connection_;
};

}  // namespace bench

#endif  // BENCH_SKELETON_BASE_H_
