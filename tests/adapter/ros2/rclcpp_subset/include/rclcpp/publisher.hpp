#ifndef RCLCPP__PUBLISHER_HPP_
#define RCLCPP__PUBLISHER_HPP_

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl/publisher.h"
#include "rclcpp/event.hpp"
#include "rclcpp/node_base.hpp"
#include "rclcpp/qos.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{

struct PublisherOptions
{
  /// Of its events.
  CallbackGroup::SharedPtr callback_group;
  PublisherEventCallbacks event_callbacks;
};

class PublisherBase
{
public:
  using SharedPtr = std::shared_ptr<PublisherBase>;

  PublisherBase(
    node_interfaces::NodeBaseInterface & node, const rosidl_message_type_support_t & type,
    const std::string & topic, const QoS & qos, const PublisherOptions & options);
  virtual ~PublisherBase() = default;

  const char * get_topic_name() const {return rcl_publisher_get_topic_name(handle_.get());}
  size_t get_subscription_count() const;
  bool assert_liveliness() const;

protected:
  void publish_message(const void * message);

private:
  void listen(node_interfaces::NodeBaseInterface & node, const PublisherOptions & options);

  std::shared_ptr<rcl_publisher_t> handle_;
  std::vector<std::shared_ptr<detail::Waitable>> events_;
};

template<typename MessageT>
class Publisher : public PublisherBase
{
public:
  using SharedPtr = std::shared_ptr<Publisher>;

  Publisher(
    node_interfaces::NodeBaseInterface & node, const std::string & topic, const QoS & qos,
    const PublisherOptions & options)
  : PublisherBase(
      node, *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>(), topic, qos, options)
  {}

  virtual void publish(const MessageT & message) {publish_message(&message);}
};

template<typename MessageT, typename NodeT>
std::shared_ptr<Publisher<MessageT>> create_publisher(
  NodeT & node, const std::string & topic, const QoS & qos, const PublisherOptions & options = {})
{
  return std::make_shared<Publisher<MessageT>>(
    *node.get_node_base_interface(), topic, qos, options);
}

}  // namespace rclcpp

#endif  // RCLCPP__PUBLISHER_HPP_
