#ifndef RCLCPP__EVENT_HPP_
#define RCLCPP__EVENT_HPP_

#include <functional>
#include <memory>
#include <utility>

#include "rcl/error_handling.h"
#include "rcl/event.h"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/exceptions.hpp"
#include "rmw/events_statuses/events_statuses.h"

namespace rclcpp
{

using QOSLivelinessChangedInfo = rmw_liveliness_changed_status_t;
using QOSLivelinessLostInfo = rmw_liveliness_lost_status_t;
using QOSMessageLostInfo = rmw_message_lost_status_t;
using QOSOfferedIncompatibleQoSInfo = rmw_offered_qos_incompatible_event_status_t;
using QOSRequestedIncompatibleQoSInfo = rmw_requested_qos_incompatible_event_status_t;

struct PublisherEventCallbacks
{
  std::function<void(QOSLivelinessLostInfo &)> liveliness_callback;
  std::function<void(QOSOfferedIncompatibleQoSInfo &)> incompatible_qos_callback;
};

struct SubscriptionEventCallbacks
{
  std::function<void(QOSLivelinessChangedInfo &)> liveliness_callback;
  std::function<void(QOSRequestedIncompatibleQoSInfo &)> incompatible_qos_callback;
  std::function<void(QOSMessageLostInfo &)> message_lost_callback;
};

namespace detail
{

/// An event of a publisher or subscription, which it keeps.
template<typename InfoT>
class Event : public Waitable
{
public:
  Event(std::shared_ptr<void> parent, std::function<void(InfoT &)> callback)
  : parent_(std::move(parent)), callback_(std::move(callback)), event_(rcl_get_zero_initialized_event())
  {}
  ~Event() override
  {
    if (rcl_event_fini(&event_) != RCL_RET_OK) {
      rcl_reset_error();
    }
  }

  rcl_event_t * handle() {return &event_;}
  Kind kind() const override {return Kind::Event;}
  const void * rcl_handle() const override {return &event_;}
  std::function<void()> take() override
  {
    InfoT info{};
    if (rcl_take_event(&event_, &info) != RCL_RET_OK) {
      rcl_reset_error();
      return {};
    }
    return [this, info]() mutable {callback_(info);};
  }

private:
  std::shared_ptr<void> parent_;
  std::function<void(InfoT &)> callback_;
  rcl_event_t event_;
};

}  // namespace detail
}  // namespace rclcpp

#endif  // RCLCPP__EVENT_HPP_
