#ifndef OVERRIDES_HPP_
#define OVERRIDES_HPP_

#include <map>
#include <string>

#include "rclcpp/node_base.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp::detail
{

/// Values of command line, parameter files and options that are for this node; the later ones win.
std::map<std::string, ParameterValue> overrides_of(
  const node_interfaces::NodeBaseInterface & node, const NodeOptions & options);

}  // namespace rclcpp::detail

#endif  // OVERRIDES_HPP_
