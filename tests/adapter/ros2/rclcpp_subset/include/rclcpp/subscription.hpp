#ifndef RCLCPP__SUBSCRIPTION_HPP_
#define RCLCPP__SUBSCRIPTION_HPP_

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "rcl/subscription.h"
#include "rclcpp/event.hpp"
#include "rclcpp/message_info.hpp"
#include "rclcpp/node_base.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

struct SubscriptionOptions
{
  CallbackGroup::SharedPtr callback_group;
  SubscriptionEventCallbacks event_callbacks;
};

class SubscriptionBase : public detail::Waitable
{
public:
  using SharedPtr = std::shared_ptr<SubscriptionBase>;

  SubscriptionBase(
    node_interfaces::NodeBaseInterface & node, const rosidl_message_type_support_t & type,
    const std::string & topic, const QoS & qos, const SubscriptionOptions & options);

  const char * get_topic_name() const {return rcl_subscription_get_topic_name(handle_.get());}
  size_t get_publisher_count() const;

  Kind kind() const override {return Kind::Subscription;}
  const void * rcl_handle() const override {return handle_.get();}

protected:
  bool take_message(void * message, MessageInfo & info);

private:
  void listen(node_interfaces::NodeBaseInterface & node, const SubscriptionOptions & options);

  std::shared_ptr<rcl_subscription_t> handle_;
  std::vector<std::shared_ptr<detail::Waitable>> events_;
};

template<typename MessageT>
class Subscription : public SubscriptionBase
{
public:
  using SharedPtr = std::shared_ptr<Subscription>;

  template<typename CallbackT>
  Subscription(
    node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    CallbackT && callback, const SubscriptionOptions & options)
  : SubscriptionBase(
      node, *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), topic, qos, options)
  {
    if constexpr (std::is_invocable_v<CallbackT, const MessageT &, const MessageInfo &>) {
      callback_ = std::forward<CallbackT>(callback);
    } else if constexpr (std::is_invocable_v<CallbackT, const MessageT &>) {
      callback_ = [callback](const MessageT & message, const MessageInfo &) {callback(message);};
    } else {
      static_assert(
        std::is_invocable_v<CallbackT, std::shared_ptr<const MessageT>>,
        "this subset calls with a message, also with its info, or a shared pointer to a constant one");
      shared_callback_ = std::forward<CallbackT>(callback);
    }
  }

  std::function<void()> take() override
  {
    auto message = std::make_shared<MessageT>();
    MessageInfo info;
    if (!take_message(message.get(), info)) {
      return {};
    }
    if (callback_) {
      return [this, message, info] {callback_(*message, info);};
    }
    return [this, message] {shared_callback_(message);};
  }

private:
  std::function<void(const MessageT &, const MessageInfo &)> callback_;
  std::function<void(std::shared_ptr<const MessageT>)> shared_callback_;
};

}  // namespace rclcpp

#endif  // RCLCPP__SUBSCRIPTION_HPP_
