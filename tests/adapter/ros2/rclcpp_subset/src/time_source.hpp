#ifndef TIME_SOURCE_HPP_
#define TIME_SOURCE_HPP_

#include <memory>
#include <thread>

#include "rclcpp/clock.hpp"
#include "rclcpp/executors.hpp"
#include "rclcpp/subscription.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace rclcpp::detail
{

/// Time of a node's clock: the system's, or that of /clock, which a thread of its own receives.
class TimeSource
{
public:
  TimeSource(node_interfaces::NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock);
  ~TimeSource();

  void use(bool is_simulated);

private:
  node_interfaces::NodeBaseInterface::SharedPtr node_;
  Clock::SharedPtr clock_;
  CallbackGroup::SharedPtr group_;
  Subscription<rosgraph_msgs::msg::Clock>::SharedPtr subscription_;
  std::unique_ptr<executors::SingleThreadedExecutor> executor_;
  std::thread thread_;
};

}  // namespace rclcpp::detail

#endif  // TIME_SOURCE_HPP_
