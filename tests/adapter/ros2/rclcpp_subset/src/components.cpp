#include <map>
#include <string>

#include "rclcpp_components/register_node_macro.hpp"

namespace rclcpp_components::detail
{

std::map<std::string, Factory> & factories()
{
  static std::map<std::string, Factory> all;
  return all;
}

}  // namespace rclcpp_components::detail
