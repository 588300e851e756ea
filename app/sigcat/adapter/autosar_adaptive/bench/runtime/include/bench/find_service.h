// Searches for instances of a service: what the static functions of every proxy do.
#ifndef BENCH_FIND_SERVICE_H_
#define BENCH_FIND_SERVICE_H_

#include "ara/com/types.h"
#include "ara/core/instance_specifier.h"
#include "bench/handle.h"

namespace bench {

using Handles = ara::com::ServiceHandleContainer<Handle>;

ara::core::Result<Handles> FindService(const ServiceDescription& service, const ara::core::InstanceSpecifier& port);
ara::core::Result<Handles> FindService(const ServiceDescription& service, const ara::com::InstanceIdentifier& instance);
ara::core::Result<ara::com::FindServiceHandle> StartFindService(const ServiceDescription& service,
                                                                ara::com::FindServiceHandler<Handle> handler,
                                                                const ara::core::InstanceSpecifier& port);
ara::core::Result<ara::com::FindServiceHandle> StartFindService(const ServiceDescription& service,
                                                                ara::com::FindServiceHandler<Handle> handler,
                                                                const ara::com::InstanceIdentifier& instance);

// The handler does not run when this has returned, unless it is the handler that calls it.
void StopFindService(ara::com::FindServiceHandle handle);

}  // namespace bench

#endif  // BENCH_FIND_SERVICE_H_
