#ifndef RCLCPP__TIME_HPP_
#define RCLCPP__TIME_HPP_

#include <chrono>
#include <cstdint>

#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"

namespace rclcpp
{

class Duration
{
public:
  template<class Rep, class Period>
  Duration(const std::chrono::duration<Rep, Period> & duration)  // NOLINT: rclcpp converts, too
  : nanoseconds_(std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count())
  {}

  rcl_duration_value_t nanoseconds() const {return nanoseconds_;}
  rmw_time_t to_rmw_time() const;

private:
  rcl_duration_value_t nanoseconds_;
};

class Time
{
public:
  explicit Time(int64_t nanoseconds = 0, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME)
  : nanoseconds_(nanoseconds), clock_type_(clock_type)
  {}

  operator builtin_interfaces::msg::Time() const;

  rcl_time_point_value_t nanoseconds() const {return nanoseconds_;}
  double seconds() const {return static_cast<double>(nanoseconds_) * 1e-9;}
  rcl_clock_type_t get_clock_type() const {return clock_type_;}

private:
  rcl_time_point_value_t nanoseconds_;
  rcl_clock_type_t clock_type_;
};

}  // namespace rclcpp

#endif  // RCLCPP__TIME_HPP_
