// The monitor of an error. It gets the verdicts of the core, which has debounced them.

#ifndef APPLICATION_ERROR_MONITOR_H
#define APPLICATION_ERROR_MONITOR_H

#include <atomic>
#include <cstdint>

#include "ara/core/instance_specifier.h"
#include "ara/diag/monitor.h"
#include "ara/log/logger.h"

namespace application {

class ErrorMonitor final {
public:
    ErrorMonitor(const char* port, ara::log::Logger& logger)
        : port_{port},
          logger_(logger),
          monitor_{ara::core::InstanceSpecifier{port},
                   [](ara::diag::InitMonitorReason) { /* the verdict of the core holds until it changes */ },
                   [this] { return counter_.load(); }} {}

    void Offer() {
        const auto offered = monitor_.Offer();
        if (!offered.HasValue()) {
            logger_.LogError() << port_ << " cannot be offered: " << offered.Error().Message();
        }
    }

    void StopOffer() { monitor_.StopOffer(); }

    void Tell(bool is_failed) {
        counter_.store(is_failed ? INT8_MAX : INT8_MIN);
        static_cast<void>(
            monitor_.ReportMonitorAction(is_failed ? ara::diag::MonitorAction::kFailed : ara::diag::MonitorAction::kPassed));
    }

private:
    const char* port_;
    ara::log::Logger& logger_;
    std::atomic<std::int8_t> counter_{0};
    ara::diag::Monitor monitor_;
};

}  // namespace application

#endif  // APPLICATION_ERROR_MONITOR_H
