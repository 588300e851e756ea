#ifndef RCLCPP__NODE_HPP_
#define RCLCPP__NODE_HPP_

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/client.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node_base.hpp"
#include "rclcpp/node_options.hpp"
#include "rclcpp/node_parameters.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp
{

namespace detail
{

class TimeSource;

/// What plain and lifecycle nodes have in common.
class NodeParts
{
public:
  const char * get_name() const {return base_->get_name();}
  const char * get_namespace() const {return base_->get_namespace();}
  Logger get_logger() const {return Logger(base_->get_logger_name());}
  Clock::SharedPtr get_clock() {return clock_;}
  Time now() const {return clock_->now();}
  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return base_;}

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType type, bool automatically_add_to_executor_with_node = true)
  {
    return base_->create_callback_group(type, automatically_add_to_executor_with_node);
  }

  template<typename MessageT, typename CallbackT>
  std::shared_ptr<Subscription<MessageT>> create_subscription(
    const std::string & topic, const QoS & qos, CallbackT && callback,
    const SubscriptionOptions & options = {})
  {
    auto made = std::make_shared<Subscription<MessageT>>(
      *base_, topic, qos, std::forward<CallbackT>(callback), options);
    base_->add(made, options.callback_group);
    return made;
  }

  template<typename CallbackT>
  TimerBase::SharedPtr create_wall_timer(
    std::chrono::nanoseconds period, CallbackT callback, CallbackGroup::SharedPtr group = nullptr)
  {
    auto made = std::make_shared<TimerBase>(base_->get_context(), period, std::move(callback));
    base_->add(made, group);
    return made;
  }

  template<typename ServiceT, typename CallbackT>
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & name, CallbackT && callback, const QoS & qos = ServicesQoS(),
    CallbackGroup::SharedPtr group = nullptr)
  {
    auto made = std::make_shared<Service<ServiceT>>(
      *base_, name, std::forward<CallbackT>(callback), qos);
    base_->add(made, group);
    return made;
  }
  template<typename ServiceT, typename CallbackT>
  [[deprecated("use rclcpp::QoS instead of rmw_qos_profile_t")]]
  std::shared_ptr<Service<ServiceT>> create_service(
    const std::string & name, CallbackT && callback, const rmw_qos_profile_t & qos,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_service<ServiceT>(
      name, std::forward<CallbackT>(callback), QoS(KeepLast(qos.depth), qos), group);
  }

  template<typename ServiceT>
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & name, const QoS & qos = ServicesQoS(), CallbackGroup::SharedPtr group = nullptr)
  {
    auto made = std::make_shared<Client<ServiceT>>(*base_, name, qos);
    base_->add(made, group);
    return made;
  }
  template<typename ServiceT>
  [[deprecated("use rclcpp::QoS instead of rmw_qos_profile_t")]]
  std::shared_ptr<Client<ServiceT>> create_client(
    const std::string & name, const rmw_qos_profile_t & qos, CallbackGroup::SharedPtr group = nullptr)
  {
    return create_client<ServiceT>(name, QoS(KeepLast(qos.depth), qos), group);
  }

  template<typename ParameterT>
  ParameterT declare_parameter(
    const std::string & name, const ParameterT & value,
    const rcl_interfaces::msg::ParameterDescriptor & descriptor =
    rcl_interfaces::msg::ParameterDescriptor())
  {
    return parameters_->declare(name, ParameterValue(value), descriptor).template get<ParameterT>();
  }
  bool has_parameter(const std::string & name) const {return parameters_->has(name);}
  Parameter get_parameter(const std::string & name) const {return parameters_->get(name);}
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter & parameter)
  {
    return parameters_->set_atomically({parameter});
  }
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(
    const std::vector<Parameter> & parameters)
  {
    return parameters_->set_atomically(parameters);
  }
  [[nodiscard]] node_interfaces::OnSetParametersCallbackHandle::SharedPtr
  add_on_set_parameters_callback(
    node_interfaces::OnSetParametersCallbackHandle::OnSetParametersCallbackType callback)
  {
    return parameters_->add_on_set(std::move(callback));
  }

  [[nodiscard]] node_interfaces::PostSetParametersCallbackHandle::SharedPtr
  add_post_set_parameters_callback(
    node_interfaces::PostSetParametersCallbackHandle::PostSetParametersCallbackType callback)
  {
    return parameters_->add_post_set(std::move(callback));
  }
  size_t count_publishers(const std::string & topic) const;
  size_t count_subscribers(const std::string & topic) const;

  NodeParts(const NodeParts &) = delete;
  NodeParts & operator=(const NodeParts &) = delete;

protected:
  NodeParts(const std::string & name, const std::string & name_space, const NodeOptions & options);
  ~NodeParts();

  node_interfaces::NodeBaseInterface::SharedPtr base_;

private:
  Clock::SharedPtr clock_;
  std::unique_ptr<node_interfaces::NodeParameters> parameters_;
  std::unique_ptr<TimeSource> time_source_;
};

}  // namespace detail

class Node : public detail::NodeParts, public std::enable_shared_from_this<Node>
{
public:
  using SharedPtr = std::shared_ptr<Node>;

  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions())
  : Node(name, "", options) {}
  Node(
    const std::string & name, const std::string & name_space,
    const NodeOptions & options = NodeOptions())
  : NodeParts(name, name_space, options) {}
  virtual ~Node() = default;

  template<typename MessageT>
  std::shared_ptr<Publisher<MessageT>> create_publisher(
    const std::string & topic, const QoS & qos, const PublisherOptions & options = {})
  {
    return std::make_shared<Publisher<MessageT>>(*base_, topic, qos, options);
  }
};

}  // namespace rclcpp

#endif  // RCLCPP__NODE_HPP_
