#ifndef RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_
#define RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "rclcpp/node_base.hpp"
#include "rclcpp/node_options.hpp"

namespace rclcpp_components::detail
{

struct Instance
{
  std::shared_ptr<void> node;
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base;
};

using Factory = std::function<Instance(const rclcpp::NodeOptions &)>;

/// What the libraries that are loaded have registered, by name of class.
std::map<std::string, Factory> & factories();

template<typename NodeT>
bool add(const char * name)
{
  return factories().emplace(
    name, [](const rclcpp::NodeOptions & options) {
      auto node = std::make_shared<NodeT>(options);
      return Instance{node, node->get_node_base_interface()};
    }).second;
}

}  // namespace rclcpp_components::detail

#define RCLCPP_COMPONENTS_SUBSET_NAME(line) rclcpp_components_registered_ ## line
#define RCLCPP_COMPONENTS_SUBSET_ADD(NodeClass, line) \
  namespace \
  { \
  [[maybe_unused]] const bool RCLCPP_COMPONENTS_SUBSET_NAME(line) = \
    ::rclcpp_components::detail::add<NodeClass>(#NodeClass); \
  }
#define RCLCPP_COMPONENTS_SUBSET_AT(NodeClass, line) RCLCPP_COMPONENTS_SUBSET_ADD(NodeClass, line)
#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) \
  RCLCPP_COMPONENTS_SUBSET_AT(NodeClass, __LINE__)

#endif  // RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_
