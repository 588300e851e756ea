#ifndef RCLCPP__CLOCK_HPP_
#define RCLCPP__CLOCK_HPP_

#include <functional>
#include <memory>
#include <mutex>

#include "rcl/time.h"
#include "rclcpp/time.hpp"

namespace rclcpp
{

struct JumpHandler
{
  using SharedPtr = std::shared_ptr<JumpHandler>;
  using pre_callback_t = std::function<void()>;
  using post_callback_t = std::function<void(const rcl_time_jump_t &)>;

  pre_callback_t pre_callback;
  post_callback_t post_callback;
};

class Clock
{
public:
  using SharedPtr = std::shared_ptr<Clock>;

  explicit Clock(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);

  Time now() const;
  bool ros_time_is_active();
  rcl_clock_type_t get_clock_type() const;
  rcl_clock_t * get_clock_handle();

  /// Called until the handler is destroyed, with the clock locked.
  JumpHandler::SharedPtr create_jump_callback(
    JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
    const rcl_jump_threshold_t & threshold);

  /// The mutex of everything that makes time jump.
  std::mutex & get_clock_mutex();

private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace rclcpp

#endif  // RCLCPP__CLOCK_HPP_
