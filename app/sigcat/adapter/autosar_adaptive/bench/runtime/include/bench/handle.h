// An instance of a service that was found (SWS_CM_00312).
#ifndef BENCH_HANDLE_H_
#define BENCH_HANDLE_H_

#include <cstdint>

#include "ara/com/instance_identifier.h"
#include "bench/description.h"

namespace bench {

class Handle final {
public:
    Handle(const ServiceDescription& service, std::uint16_t instance) noexcept
        : service_{&service}, instance_{instance} {}

    ara::com::InstanceIdentifier GetInstanceId() const;
    bool operator==(const Handle& other) const noexcept {
        return service_ == other.service_ && instance_ == other.instance_;
    }
    bool operator<(const Handle& other) const noexcept { return instance_ < other.instance_; }

    const ServiceDescription& Service() const noexcept { return *service_; }
    std::uint16_t Instance() const noexcept { return instance_; }

private:
    const ServiceDescription* service_;
    std::uint16_t instance_;
};

}  // namespace bench

#endif  // BENCH_HANDLE_H_
