#include "PACKAGE_NAME/receiver.hpp"

#include <thread>

namespace PACKAGE_NAME
{

Receiver::Receiver(
  const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node,
  const rclcpp::CallbackGroup::SharedPtr & group)
{
  executor_.add_callback_group(group, node);
  thread_ = std::thread(
    [this, end = end_.get_future().share()] {executor_.spin_until_future_complete(end);});
}

Receiver::~Receiver()
{
  end_.set_value();  // cancelling alone is lost on an executor that does not spin yet
  executor_.cancel();
  thread_.join();
}

}  // namespace PACKAGE_NAME
