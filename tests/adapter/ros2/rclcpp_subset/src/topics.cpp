#include <memory>
#include <string>
#include <utility>

#include "rcl/error_handling.h"
#include "rclcpp/logging.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/subscription.hpp"
#include "rmw/qos_string_conversions.h"

namespace rclcpp
{

namespace
{

using node_interfaces::NodeBaseInterface;

std::shared_ptr<rcl_publisher_t> make_publisher(
  const NodeBaseInterface & node, const rosidl_message_type_support_t & type,
  const std::string & topic, const QoS & qos)
{
  auto node_handle = node.get_shared_rcl_node_handle();
  auto publisher = std::make_unique<rcl_publisher_t>(rcl_get_zero_initialized_publisher());
  rcl_publisher_options_t options = rcl_publisher_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  detail::check(
    rcl_publisher_init(publisher.get(), node_handle.get(), &type, topic.c_str(), &options),
    topic.c_str());
  return {publisher.release(), [node_handle](rcl_publisher_t * gone) {
      if (rcl_publisher_fini(gone, node_handle.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      delete gone;
    }};
}

std::shared_ptr<rcl_subscription_t> make_subscription(
  const NodeBaseInterface & node, const rosidl_message_type_support_t & type,
  const std::string & topic, const QoS & qos)
{
  auto node_handle = node.get_shared_rcl_node_handle();
  auto subscription = std::make_unique<rcl_subscription_t>(rcl_get_zero_initialized_subscription());
  rcl_subscription_options_t options = rcl_subscription_get_default_options();
  options.qos = qos.get_rmw_qos_profile();
  const rcl_ret_t made = rcl_subscription_init(
    subscription.get(), node_handle.get(), &type, topic.c_str(), &options);
  detail::check(made, topic.c_str());
  return {subscription.release(), [node_handle](rcl_subscription_t * gone) {
      if (rcl_subscription_fini(gone, node_handle.get()) != RCL_RET_OK) {
        rcl_reset_error();
      }
      delete gone;
    }};
}

template<typename InfoT, typename InitT, typename HandleT, typename KindT>
std::shared_ptr<detail::Waitable> listen_to(
  InitT init, const std::shared_ptr<HandleT> & parent, KindT kind,
  const std::function<void(InfoT &)> & callback)
{
  auto event = std::make_shared<detail::Event<InfoT>>(parent, callback);
  detail::check(init(event->handle(), parent.get(), kind), "event");
  return event;
}

/// Whether all that is wrong with a publisher is that its context was shut down, which any call may find.
bool is_after_shutdown(const rcl_publisher_t & publisher, rcl_ret_t result)
{
  if (result != RCL_RET_PUBLISHER_INVALID) {
    return false;
  }
  rcl_reset_error();
  return rcl_publisher_is_valid_except_context(&publisher);
}

std::string told_of(const char * topic, const char * who, rmw_qos_policy_kind_t policy)
{
  const char * name = rmw_qos_policy_kind_to_str(policy);
  return "New " + std::string(who) + " on topic '" + topic +
         "' with incompatible QoS. Last incompatible policy: " + (name ? name : "unknown");
}

}  // namespace

QoS::QoS(KeepLast history, const rmw_qos_profile_t & profile)
: profile_(profile)
{
  profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  profile_.depth = history.depth;
}

QoS & QoS::reliable()
{
  profile_.reliability = RMW_QOS_POLICY_RELIABILITY_RELIABLE;
  return *this;
}

QoS & QoS::best_effort()
{
  profile_.reliability = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT;
  return *this;
}

QoS & QoS::transient_local()
{
  profile_.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  return *this;
}

QoS & QoS::keep_last(size_t depth)
{
  profile_.history = RMW_QOS_POLICY_HISTORY_KEEP_LAST;
  profile_.depth = depth;
  return *this;
}

QoS & QoS::durability_volatile()
{
  profile_.durability = RMW_QOS_POLICY_DURABILITY_VOLATILE;
  return *this;
}

QoS & QoS::deadline(const Duration & deadline)
{
  profile_.deadline = deadline.to_rmw_time();
  return *this;
}

QoS & QoS::lifespan(const Duration & lifespan)
{
  profile_.lifespan = lifespan.to_rmw_time();
  return *this;
}

QoS & QoS::liveliness(LivelinessPolicy policy)
{
  profile_.liveliness = static_cast<rmw_qos_liveliness_policy_t>(policy);
  return *this;
}

QoS & QoS::liveliness_lease_duration(const Duration & lease)
{
  profile_.liveliness_lease_duration = lease.to_rmw_time();
  return *this;
}

PublisherBase::PublisherBase(
  NodeBaseInterface & node, const rosidl_message_type_support_t & type,
  const std::string & topic, const QoS & qos, const PublisherOptions & options)
: handle_(make_publisher(node, type, topic, qos))
{
  listen(node, options);
}

void PublisherBase::listen(NodeBaseInterface & node, const PublisherOptions & options)
{
  const PublisherEventCallbacks & callbacks = options.event_callbacks;
  const auto add = [this](auto kind, const auto & callback) {
      if (callback) {
        events_.push_back(listen_to(rcl_publisher_event_init, handle_, kind, callback));
      }
    };
  add(RCL_PUBLISHER_LIVELINESS_LOST, callbacks.liveliness_callback);
  std::function<void(QOSOfferedIncompatibleQoSInfo &)> incompatible = callbacks.incompatible_qos_callback;
  if (!incompatible) {
    const Logger logger(node.get_logger_name());
    incompatible = [logger, topic = std::string(get_topic_name())](auto & info) {
        const std::string text = told_of(topic.c_str(), "subscription", info.last_policy_kind);
        RCLCPP_WARN(logger, "%s", text.c_str());
      };
  }
  add(RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS, incompatible);
  for (const auto & event : events_) {
    node.add(event, options.callback_group);
  }
}

size_t PublisherBase::get_subscription_count() const
{
  size_t count = 0;
  const rcl_ret_t counted = rcl_publisher_get_subscription_count(handle_.get(), &count);
  if (!is_after_shutdown(*handle_, counted)) {
    detail::check(counted, get_topic_name());
  }
  return count;
}

bool PublisherBase::assert_liveliness() const
{
  return rcl_publisher_assert_liveliness(handle_.get()) == RCL_RET_OK;
}

void PublisherBase::publish_message(const void * message)
{
  const rcl_ret_t published = rcl_publish(handle_.get(), message, nullptr);
  if (!is_after_shutdown(*handle_, published)) {
    detail::check(published, get_topic_name());
  }
}

SubscriptionBase::SubscriptionBase(
  NodeBaseInterface & node, const rosidl_message_type_support_t & type,
  const std::string & topic, const QoS & qos, const SubscriptionOptions & options)
: handle_(make_subscription(node, type, topic, qos))
{
  listen(node, options);
}

void SubscriptionBase::listen(NodeBaseInterface & node, const SubscriptionOptions & options)
{
  const SubscriptionEventCallbacks & callbacks = options.event_callbacks;
  const auto add = [this](auto kind, const auto & callback) {
      if (callback) {
        events_.push_back(listen_to(rcl_subscription_event_init, handle_, kind, callback));
      }
    };
  add(RCL_SUBSCRIPTION_LIVELINESS_CHANGED, callbacks.liveliness_callback);
  add(RCL_SUBSCRIPTION_MESSAGE_LOST, callbacks.message_lost_callback);
  std::function<void(QOSRequestedIncompatibleQoSInfo &)> incompatible = callbacks.incompatible_qos_callback;
  if (!incompatible) {
    const Logger logger(node.get_logger_name());
    incompatible = [logger, topic = std::string(get_topic_name())](auto & info) {
        const std::string text = told_of(topic.c_str(), "publisher", info.last_policy_kind);
        RCLCPP_WARN(logger, "%s", text.c_str());
      };
  }
  add(RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS, incompatible);
  for (const auto & event : events_) {
    node.add(event, options.callback_group);
  }
}

size_t SubscriptionBase::get_publisher_count() const
{
  size_t count = 0;
  detail::check(rcl_subscription_get_publisher_count(handle_.get(), &count), get_topic_name());
  return count;
}

bool SubscriptionBase::take_message(void * message, MessageInfo & info)
{
  const rcl_ret_t taken = rcl_take(handle_.get(), message, &info.get_rmw_message_info(), nullptr);
  if (taken == RCL_RET_SUBSCRIPTION_TAKE_FAILED) {
    rcl_reset_error();
    return false;
  }
  detail::check(taken, get_topic_name());
  return true;
}

}  // namespace rclcpp
