// A message while it is written; it is sent when the stream goes (SWS_LOG_00039).
#ifndef ARA_LOG_LOG_STREAM_H_
#define ARA_LOG_LOG_STREAM_H_

#include <string>
#include <type_traits>
#include <utility>

#include "ara/core/error_code.h"
#include "ara/core/instance_specifier.h"
#include "ara/core/string_view.h"
#include "ara/log/common.h"

namespace ara::log {

class LogStream final {
public:
    // With an empty context nothing is written.
    LogStream(LogLevel level, ara::core::StringView context) : level_{level}, context_{context} {}
    ~LogStream() { Flush(); }
    LogStream(const LogStream&) = delete;
    LogStream& operator=(const LogStream&) = delete;
    LogStream(LogStream&& other) noexcept
        : level_{other.level_}, context_{std::exchange(other.context_, {})}, text_{std::move(other.text_)} {}
    LogStream& operator=(LogStream&&) = delete;

    void Flush() noexcept;

    LogStream& operator<<(ara::core::StringView text) {
        text_ += text;
        return *this;
    }
    LogStream& operator<<(const char* text) { return *this << ara::core::StringView{text}; }
    LogStream& operator<<(bool value) { return *this << (value ? "true" : "false"); }
    LogStream& operator<<(const ara::core::ErrorCode& code) { return *this << code.Message(); }
    LogStream& operator<<(const ara::core::InstanceSpecifier& port) { return *this << port.ToString(); }

    template <typename Number, typename = std::enable_if_t<std::is_arithmetic_v<Number>>>
    LogStream& operator<<(Number value) {
        text_ += std::to_string(value);
        return *this;
    }

private:
    LogLevel level_;
    ara::core::StringView context_;
    std::string text_;
};

}  // namespace ara::log

#endif  // ARA_LOG_LOG_STREAM_H_
