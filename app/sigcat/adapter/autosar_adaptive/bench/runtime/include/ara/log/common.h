// How urgent a message is (SWS_LOG_00018).
#ifndef ARA_LOG_COMMON_H_
#define ARA_LOG_COMMON_H_

#include <cstdint>

namespace ara::log {

enum class LogLevel : std::uint8_t {
    kOff = 0,
    kFatal = 1,
    kError = 2,
    kWarn = 3,
    kInfo = 4,
    kDebug = 5,
    kVerbose = 6,
};

}  // namespace ara::log

#endif  // ARA_LOG_COMMON_H_
