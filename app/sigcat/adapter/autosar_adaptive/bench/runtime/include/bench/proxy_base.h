// What every proxy has, whatever its service: searches, and the handle that it was made of.
#ifndef BENCH_PROXY_BASE_H_
#define BENCH_PROXY_BASE_H_

#include <memory>
#include <utility>

#include "bench/find_service.h"
#include "bench/proxy_connection.h"

namespace bench {

template <const ServiceDescription& Service>
class ProxyBase {
public:
    using HandleType = Handle;

    static ara::core::Result<ara::com::ServiceHandleContainer<HandleType>> FindService(
        const ara::core::InstanceSpecifier& instance) {
        return bench::FindService(Service, instance);
    }
    static ara::core::Result<ara::com::ServiceHandleContainer<HandleType>> FindService(
        const ara::com::InstanceIdentifier& instance) {
        return bench::FindService(Service, instance);
    }
    static ara::core::Result<ara::com::FindServiceHandle> StartFindService(
        ara::com::FindServiceHandler<HandleType> handler, const ara::core::InstanceSpecifier& instance) {
        return bench::StartFindService(Service, std::move(handler), instance);
    }
    static ara::core::Result<ara::com::FindServiceHandle> StartFindService(
        ara::com::FindServiceHandler<HandleType> handler, const ara::com::InstanceIdentifier& instance) {
        return bench::StartFindService(Service, std::move(handler), instance);
    }
    static void StopFindService(ara::com::FindServiceHandle handle) { bench::StopFindService(handle); }

    HandleType GetHandle() const { return connection_->GetHandle(); }

protected:
    explicit ProxyBase(const HandleType& handle) : connection_{std::make_shared<ProxyConnection>(handle)} {}
    ProxyBase(ProxyBase&&) noexcept = default;
    ProxyBase& operator=(ProxyBase&&) noexcept = default;
    ~ProxyBase() = default;

    std::shared_ptr<ProxyConnection> connection_;
};

}  // namespace bench

#endif  // BENCH_PROXY_BASE_H_
