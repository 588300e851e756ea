// Messages of a part of the application (SWS_LOG_00221). The bench writes them to standard error, a line each.
#ifndef ARA_LOG_LOGGER_H_
#define ARA_LOG_LOGGER_H_

#include <string>

#include "ara/core/string_view.h"
#include "ara/log/common.h"
#include "ara/log/log_stream.h"

namespace ara::log {

class Logger final {
public:
    explicit Logger(ara::core::StringView context) : context_{context} {}
    Logger(const Logger&) = delete;
    Logger& operator=(const Logger&) = delete;

    LogStream LogFatal() const noexcept { return WithLevel(LogLevel::kFatal); }
    LogStream LogError() const noexcept { return WithLevel(LogLevel::kError); }
    LogStream LogWarn() const noexcept { return WithLevel(LogLevel::kWarn); }
    LogStream LogInfo() const noexcept { return WithLevel(LogLevel::kInfo); }
    LogStream LogDebug() const noexcept { return WithLevel(LogLevel::kDebug); }
    LogStream LogVerbose() const noexcept { return WithLevel(LogLevel::kVerbose); }
    LogStream WithLevel(LogLevel level) const noexcept {
        return {level, IsEnabled(level) ? ara::core::StringView{context_} : ara::core::StringView{}};
    }
    // Up to the level that BENCH_LOG_LEVEL says, from 0 (off) to 6 (verbose); 3 (warnings) if it does not.
    bool IsEnabled(LogLevel level) const noexcept;

private:
    std::string context_;
};

// The same one for the same id, for as long as the process lives.
Logger& CreateLogger(ara::core::StringView ctxId, ara::core::StringView ctxDescription);

}  // namespace ara::log

#endif  // ARA_LOG_LOGGER_H_
