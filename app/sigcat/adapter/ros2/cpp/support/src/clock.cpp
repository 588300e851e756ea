#include "PACKAGE_NAME/clock.hpp"

#include <chrono>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

namespace PACKAGE_NAME
{

namespace
{

constexpr uint64_t kLatest = static_cast<uint64_t>(std::numeric_limits<int64_t>::max());

}  // namespace

bool Clock::wait_until(uint64_t time)
{
  std::unique_lock<std::mutex> lock(mutex_);
  wait(lock, time);
  is_woken_ = false;
  return !is_stopped_;
}

void Clock::wake()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_woken_ = true;
  }
  changed_.notify_all();
}

void Clock::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_stopped_ = true;
  }
  changed_.notify_all();
}

void Clock::resume()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  is_stopped_ = false;
  is_woken_ = false;
}

bool Clock::is_stopped() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_stopped_;
}

SteadyClock::SteadyClock(rclcpp::Clock::SharedPtr node_clock)
: node_clock_(std::move(node_clock))
{
}

uint64_t SteadyClock::now() const
{
  const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<uint64_t>(
    std::chrono::duration_cast<std::chrono::nanoseconds>(since_start).count());
}

builtin_interfaces::msg::Time SteadyClock::stamp() const
{
  return node_clock_->now();
}

void SteadyClock::wait(std::unique_lock<std::mutex> & lock, uint64_t time)
{
  if (time > kLatest) {
    changed_.wait(lock, [this] {return is_interrupted();});
    return;
  }
  const std::chrono::nanoseconds since_start(static_cast<int64_t>(time));
  const std::chrono::time_point<std::chrono::steady_clock, std::chrono::nanoseconds> end(
    since_start);
  changed_.wait_until(lock, end, [this] {return is_interrupted();});
}

SimulatedClock::SimulatedClock(rclcpp::Clock::SharedPtr node_clock)
: node_clock_(std::move(node_clock))
{
  rcl_jump_threshold_t any{};
  any.on_clock_change = true;
  any.min_forward.nanoseconds = 1;
  any.min_backward.nanoseconds = -1;
  const auto has_jumped = [this](const rcl_time_jump_t & jump) {
      if (jump.clock_change == RCL_ROS_TIME_NO_CHANGE && jump.delta.nanoseconds < 0) {
        gone_back_ -= jump.delta.nanoseconds;
        is_back_ = true;
        wake();
        return;
      }
      {
        const std::lock_guard<std::mutex> lock(mutex_);
      }
      changed_.notify_all();
    };
  jumps_ = node_clock_->create_jump_callback(nullptr, has_jumped, any);
}

uint64_t SimulatedClock::now() const
{
  return static_cast<uint64_t>(node_clock_->now().nanoseconds() + gone_back_);
}

builtin_interfaces::msg::Time SimulatedClock::stamp() const
{
  return node_clock_->now();
}

void SimulatedClock::wait(std::unique_lock<std::mutex> & lock, uint64_t time)
{
  changed_.wait(lock, [this, time] {return is_interrupted() || now() >= time;});
}

uint64_t StepClock::now() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return time_;
}

builtin_interfaces::msg::Time StepClock::stamp() const
{
  constexpr uint64_t kSecond = 1000000000U;
  const uint64_t time = now();
  builtin_interfaces::msg::Time stamp;
  stamp.sec = static_cast<int32_t>(time / kSecond);
  stamp.nanosec = static_cast<uint32_t>(time % kSecond);
  return stamp;
}

void StepClock::set(uint64_t time)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_ = time;
  }
  changed_.notify_all();
}

void StepClock::wait(std::unique_lock<std::mutex> & lock, uint64_t time)
{
  changed_.wait(lock, [this, time] {return is_interrupted() || time_ >= time;});
}

}  // namespace PACKAGE_NAME
