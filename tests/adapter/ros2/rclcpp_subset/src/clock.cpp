#include "rclcpp/clock.hpp"

#include <memory>
#include <utility>

#include "rcl/error_handling.h"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

rmw_time_t Duration::to_rmw_time() const
{
  constexpr int64_t second = 1'000'000'000;
  return {
    static_cast<uint64_t>(nanoseconds_ / second), static_cast<uint64_t>(nanoseconds_ % second)};
}

Time::operator builtin_interfaces::msg::Time() const
{
  constexpr int64_t second = 1'000'000'000;
  builtin_interfaces::msg::Time message;
  message.sec = static_cast<int32_t>(nanoseconds_ / second);
  message.nanosec = static_cast<uint32_t>(nanoseconds_ % second);
  return message;
}

struct Clock::Impl
{
  explicit Impl(rcl_clock_type_t type)
  : allocator(rcl_get_default_allocator())
  {
    detail::check(rcl_clock_init(type, &clock, &allocator), "clock");
  }
  ~Impl()
  {
    if (rcl_clock_fini(&clock) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

  rcl_allocator_t allocator;
  rcl_clock_t clock;
  std::mutex mutex;
};

Clock::Clock(rcl_clock_type_t clock_type)
: impl_(std::make_shared<Impl>(clock_type))
{
}

Time Clock::now() const
{
  rcl_time_point_value_t nanoseconds = 0;
  detail::check(rcl_clock_get_now(&impl_->clock, &nanoseconds), "time");
  return Time(nanoseconds, impl_->clock.type);
}

bool Clock::ros_time_is_active()
{
  bool is_enabled = false;
  detail::check(rcl_is_enabled_ros_time_override(&impl_->clock, &is_enabled), "time");
  return is_enabled;
}

rcl_clock_type_t Clock::get_clock_type() const
{
  return impl_->clock.type;
}

rcl_clock_t * Clock::get_clock_handle()
{
  return &impl_->clock;
}

std::mutex & Clock::get_clock_mutex()
{
  return impl_->mutex;
}

static void jump(const rcl_time_jump_t * jump, bool is_before, void * data)
{
  const auto * handler = static_cast<const JumpHandler *>(data);
  if (is_before && handler->pre_callback) {
    handler->pre_callback();
  } else if (!is_before && handler->post_callback) {
    handler->post_callback(*jump);
  }
}

JumpHandler::SharedPtr Clock::create_jump_callback(
  JumpHandler::pre_callback_t pre_callback, JumpHandler::post_callback_t post_callback,
  const rcl_jump_threshold_t & threshold)
{
  auto handler = std::make_unique<JumpHandler>(
    JumpHandler{std::move(pre_callback), std::move(post_callback)});
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  detail::check(
    rcl_clock_add_jump_callback(&impl_->clock, threshold, jump, handler.get()), "jump callback");
  return {handler.release(), [weak = std::weak_ptr<Impl>(impl_)](JumpHandler * gone) {
      if (auto impl = weak.lock()) {
        const std::lock_guard<std::mutex> guard(impl->mutex);
        if (rcl_clock_remove_jump_callback(&impl->clock, jump, gone) != RCL_RET_OK) {
          rcl_reset_error();
        }
      }
      delete gone;
    }};
}

TimerBase::TimerBase(
  std::shared_ptr<detail::Context> context, std::chrono::nanoseconds period,
  std::function<void()> callback)
: context_(std::move(context)), clock_(RCL_STEADY_TIME), callback_(std::move(callback)),
  timer_(rcl_get_zero_initialized_timer())
{
  detail::check(
    rcl_timer_init2(
      &timer_, clock_.get_clock_handle(), context_->handle(), period.count(), nullptr,
      rcl_get_default_allocator(), true), "timer");
}

TimerBase::~TimerBase()
{
  if (rcl_timer_fini(&timer_) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

void TimerBase::cancel()
{
  detail::check(rcl_timer_cancel(&timer_), "timer");
}

void TimerBase::reset()
{
  detail::check(rcl_timer_reset(&timer_), "timer");
}

std::function<void()> TimerBase::take()
{
  bool is_ready = false;
  detail::check(rcl_timer_is_ready(&timer_, &is_ready), "timer");
  if (!is_ready || rcl_timer_call(&timer_) != RCL_RET_OK) {
    rcl_reset_error();
    return {};
  }
  return callback_;
}

}  // namespace rclcpp
