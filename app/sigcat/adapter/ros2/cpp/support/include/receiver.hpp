// The thread in which a node receives.

#ifndef PACKAGE_GUARD__RECEIVER_HPP_
#define PACKAGE_GUARD__RECEIVER_HPP_

#include <future>
#include <thread>

#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

/// Executes the callbacks of one group, whatever the executor of the node does meanwhile. It waits
/// for that group alone, so a message is not delayed by the services of the node.
class Receiver
{
public:
  /// No other executor may have the group.
  Receiver(
    const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node,
    const rclcpp::CallbackGroup::SharedPtr & group, const rclcpp::Logger & logger);

  /// Waits for the callback that runs.
  ~Receiver();
  Receiver(const Receiver &) = delete;
  Receiver & operator=(const Receiver &) = delete;

private:
  void receive(const std::shared_future<void> & end);

  rclcpp::Logger logger_;
  rclcpp::executors::SingleThreadedExecutor executor_;
  std::promise<void> end_;
  std::thread thread_;
};

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__RECEIVER_HPP_
