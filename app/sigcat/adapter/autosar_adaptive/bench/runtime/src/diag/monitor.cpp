#include "ara/diag/monitor.h"

#include <utility>

#include "ara/diag/diag_error_domain.h"
#include "ara/log/logger.h"

namespace ara::diag {

const char* DiagErrorDomain::Message(CodeType code) const noexcept {
    switch (static_cast<Errc>(code)) {
        case Errc::kAlreadyOffered:
            return "offered already";
        case Errc::kNotOffered:
            return "not offered";
        case Errc::kReportIgnored:
            return "the report was ignored";
        case Errc::kConfigurationMismatch:
        case Errc::kDebouncingConfigurationInconsistent:
        case Errc::kInvalidArgument:
        case Errc::kGenericError:
            break;
    }
    return "error of diagnosis";
}

const ara::core::ErrorDomain& GetDiagErrorDomain() noexcept {
    static const DiagErrorDomain domain;
    return domain;
}

Monitor::Monitor(const ara::core::InstanceSpecifier& specifier, std::function<void(InitMonitorReason)> initMonitor,
                 std::function<std::int8_t()> getFaultDetectionCounter)
    : specifier_{specifier}, init_{std::move(initMonitor)}, counter_{std::move(getFaultDetectionCounter)} {}

ara::core::Result<void> Monitor::Offer() {
    if (is_offered_) {
        return ara::core::Result<void>::FromError(DiagErrc::kAlreadyOffered);
    }
    is_offered_ = true;
    init_(InitMonitorReason::kRestart);
    return {};
}

void Monitor::StopOffer() { is_offered_ = false; }

ara::core::Result<void> Monitor::ReportMonitorAction(MonitorAction action) {
    if (!is_offered_) {
        return ara::core::Result<void>::FromError(DiagErrc::kNotOffered);
    }
    auto& logger = ara::log::CreateLogger("DIAG", "Diagnosis");
    if (action == MonitorAction::kFailed) {
        logger.LogWarn() << specifier_ << " has failed, its counter is " << static_cast<int>(counter_());
    } else {
        logger.LogInfo() << specifier_ << " reports action " << static_cast<std::uint32_t>(action);
    }
    return {};
}

}  // namespace ara::diag
