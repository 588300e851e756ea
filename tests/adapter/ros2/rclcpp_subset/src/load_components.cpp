/// Many nodes in one thread of one process: load_components PACKAGE CLASS=NAMESPACE... [--ros-args ...]

#include <dlfcn.h>

#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ament_index_cpp/get_resource.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace
{

void load(const std::string & package)
{
  std::string lines;
  std::string prefix;
  if (!ament_index_cpp::get_resource("rclcpp_components", package, lines, &prefix)) {
    throw std::runtime_error("no components in " + package);
  }
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line); ) {
    const std::string library = prefix + "/" + line.substr(line.find(';') + 1);
    if (!dlopen(library.c_str(), RTLD_NOW)) {
      throw std::runtime_error(dlerror());
    }
  }
}

rclcpp_components::detail::Instance make(const std::string & what)
{
  const size_t sign = what.find('=');
  rclcpp::NodeOptions options;
  options.arguments({"--ros-args", "-r", "__ns:=" + what.substr(sign + 1)});
  return rclcpp_components::detail::factories().at(what.substr(0, sign))(options);
}

}  // namespace

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  load(argv[1]);
  rclcpp::executors::SingleThreadedExecutor executor;
  std::vector<rclcpp_components::detail::Instance> made;
  for (int at = 2; at < argc && std::strcmp(argv[at], "--ros-args") != 0; ++at) {
    made.push_back(make(argv[at]));
    executor.add_node(made.back().base);
  }
  executor.spin();
  for (const auto & each : made) {
    executor.remove_node(each.base);
  }
  return 0;
}
