#ifndef RCLCPP__LOGGING_HPP_
#define RCLCPP__LOGGING_HPP_

#include <string>
#include <type_traits>
#include <utility>

#include "rcutils/logging_macros.h"

namespace rclcpp
{

class Logger
{
public:
  explicit Logger(std::string name)
  : name_(std::move(name)) {}

  const char * get_name() const {return name_.c_str();}

private:
  std::string name_;
};

inline Logger get_logger(const std::string & name)
{
  return Logger(name);
}

}  // namespace rclcpp

#define RCLCPP_SUBSET_LOG(severity, logger, ...) \
  do { \
    static_assert( \
      std::is_convertible_v<decltype(logger), ::rclcpp::Logger>, "the first argument is a logger"); \
    RCUTILS_LOG_ ## severity ## _NAMED((logger).get_name(), __VA_ARGS__); \
  } while (0)

#define RCLCPP_DEBUG(logger, ...) RCLCPP_SUBSET_LOG(DEBUG, logger, __VA_ARGS__)
#define RCLCPP_INFO(logger, ...) RCLCPP_SUBSET_LOG(INFO, logger, __VA_ARGS__)
#define RCLCPP_WARN(logger, ...) RCLCPP_SUBSET_LOG(WARN, logger, __VA_ARGS__)
#define RCLCPP_ERROR(logger, ...) RCLCPP_SUBSET_LOG(ERROR, logger, __VA_ARGS__)
#define RCLCPP_FATAL(logger, ...) RCLCPP_SUBSET_LOG(FATAL, logger, __VA_ARGS__)

#endif  // RCLCPP__LOGGING_HPP_
