#include "ara/log/logger.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>

namespace ara::log {

namespace {

const char* NameOf(LogLevel level) noexcept {
    switch (level) {
        case LogLevel::kFatal:
            return "fatal";
        case LogLevel::kError:
            return "error";
        case LogLevel::kWarn:
            return "warning";
        case LogLevel::kInfo:
            return "info";
        case LogLevel::kDebug:
            return "debug";
        case LogLevel::kVerbose:
        case LogLevel::kOff:
            break;
    }
    return "verbose";
}

int MostVerbose() noexcept {
    const char* const chosen = std::getenv("BENCH_LOG_LEVEL");
    return chosen == nullptr ? static_cast<int>(LogLevel::kWarn) : std::atoi(chosen);
}

}  // namespace

void LogStream::Flush() noexcept {
    if (!context_.empty() && !text_.empty()) {
        std::fprintf(stderr, "%.*s %s: %s\n", static_cast<int>(context_.size()), context_.data(), NameOf(level_),
                     text_.c_str());
    }
    text_.clear();
}

bool Logger::IsEnabled(LogLevel level) const noexcept {
    static const int most = MostVerbose();
    return static_cast<int>(level) <= most;
}

Logger& CreateLogger(ara::core::StringView ctxId, ara::core::StringView /* ctxDescription */) {
    static std::mutex mutex;
    static std::map<std::string, Logger, std::less<>> loggers;
    const std::lock_guard<std::mutex> lock{mutex};
    return loggers.try_emplace(std::string{ctxId}, ctxId).first->second;
}

}  // namespace ara::log
