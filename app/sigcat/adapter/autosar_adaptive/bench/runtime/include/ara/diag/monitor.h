// What an application tells the diagnosis of an error (SWS_DM_00538).
#ifndef ARA_DIAG_MONITOR_H_
#define ARA_DIAG_MONITOR_H_

#include <cstdint>
#include <functional>

#include "ara/core/instance_specifier.h"
#include "ara/core/result.h"

namespace ara::diag {

enum class InitMonitorReason : std::uint32_t { kClear = 0, kRestart = 1, kReenabled = 2, kDisabled = 3 };

enum class MonitorAction : std::uint32_t {
    kPassed = 0,
    kFailed = 1,
    kPrepassed = 2,
    kPrefailed = 3,
    kFdcThresholdReached = 4,
    kResetTestFailed = 5,
    kFreezeDebouncing = 6,
    kResetDebouncing = 7,
};

// Of an error that the application debounces itself. The bench has no fault memory: a verdict is a line of the log.
class Monitor final {
public:
    Monitor(const ara::core::InstanceSpecifier& specifier, std::function<void(InitMonitorReason)> initMonitor,
            std::function<std::int8_t()> getFaultDetectionCounter);
    Monitor(const Monitor&) = delete;
    Monitor& operator=(const Monitor&) = delete;

    ara::core::Result<void> Offer();
    void StopOffer();
    ara::core::Result<void> ReportMonitorAction(MonitorAction action);

private:
    ara::core::InstanceSpecifier specifier_;
    std::function<void(InitMonitorReason)> init_;
    std::function<std::int8_t()> counter_;
    bool is_offered_{false};
};

}  // namespace ara::diag

#endif  // ARA_DIAG_MONITOR_H_
