#ifndef RCLCPP__NODE_PARAMETERS_HPP_
#define RCLCPP__NODE_PARAMETERS_HPP_

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/parameter_event.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/node_base.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/publisher.hpp"

namespace rclcpp::node_interfaces
{

struct OnSetParametersCallbackHandle
{
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
  using OnSetParametersCallbackType =
    std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<rclcpp::Parameter> &)>;

  OnSetParametersCallbackType callback;
};

struct PostSetParametersCallbackHandle
{
  using SharedPtr = std::shared_ptr<PostSetParametersCallbackHandle>;
  using PostSetParametersCallbackType = std::function<void(const std::vector<rclcpp::Parameter> &)>;

  PostSetParametersCallbackType callback;
};

/// Parameters of a node, their services and the events that tell of them.
class NodeParameters
{
public:
  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using Result = rcl_interfaces::msg::SetParametersResult;
  using Parameters = std::vector<Parameter>;

  NodeParameters(
    NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock, const NodeOptions & options);

  const ParameterValue & declare(
    const std::string & name, const ParameterValue & value, const Descriptor & descriptor);
  bool has(const std::string & name) const;
  Parameter get(const std::string & name) const;
  Descriptor describe(const std::string & name) const;
  rcl_interfaces::msg::ListParametersResult list(
    const std::vector<std::string> & prefixes, uint64_t depth) const;
  Result set_atomically(const Parameters & parameters);

  OnSetParametersCallbackHandle::SharedPtr add_on_set(
    OnSetParametersCallbackHandle::OnSetParametersCallbackType callback);
  PostSetParametersCallbackHandle::SharedPtr add_post_set(
    PostSetParametersCallbackHandle::PostSetParametersCallbackType callback);
  /// Called with what was set.
  void after_set(std::function<void(const Parameters &)> callback);

private:
  struct Declared
  {
    ParameterValue value;
    Descriptor descriptor;
  };

  const Declared & at(const std::string & name) const;
  Result check(const Parameters & parameters, const std::map<std::string, Descriptor> & descriptors);
  void tell(const Parameters & parameters, bool are_new);
  void serve();
  template<typename ServiceT, typename CallbackT>
  void serve(const std::string & name, CallbackT callback);

  NodeBaseInterface::SharedPtr node_;
  Clock::SharedPtr clock_;
  Publisher<rcl_interfaces::msg::ParameterEvent> events_;
  mutable std::recursive_mutex mutex_;
  std::map<std::string, ParameterValue> overrides_;
  std::map<std::string, Declared> declared_;
  std::list<std::weak_ptr<OnSetParametersCallbackHandle>> on_set_;
  std::list<std::weak_ptr<PostSetParametersCallbackHandle>> post_set_;
  std::function<void(const Parameters &)> after_set_;
  std::vector<std::shared_ptr<detail::Waitable>> services_;
};

}  // namespace rclcpp::node_interfaces

#endif  // RCLCPP__NODE_PARAMETERS_HPP_
