#ifndef RCLCPP__TIMER_HPP_
#define RCLCPP__TIMER_HPP_

#include <chrono>
#include <functional>
#include <memory>

#include "rcl/timer.h"
#include "rclcpp/clock.hpp"
#include "rclcpp/node_base.hpp"

namespace rclcpp
{

class TimerBase : public detail::Waitable
{
public:
  using SharedPtr = std::shared_ptr<TimerBase>;

  TimerBase(
    std::shared_ptr<detail::Context> context, std::chrono::nanoseconds period,
    std::function<void()> callback);
  ~TimerBase() override;

  void cancel();
  void reset();

  Kind kind() const override {return Kind::Timer;}
  const void * rcl_handle() const override {return &timer_;}
  std::function<void()> take() override;

private:
  std::shared_ptr<detail::Context> context_;
  Clock clock_;
  std::function<void()> callback_;
  rcl_timer_t timer_;
};

}  // namespace rclcpp

#endif  // RCLCPP__TIMER_HPP_
