#include "PACKAGE_NAME/receiver.hpp"

#include <chrono>
#include <future>
#include <thread>

#include "PACKAGE_NAME/guard.hpp"

namespace PACKAGE_NAME
{

Receiver::Receiver(
  const rclcpp::node_interfaces::NodeBaseInterface::SharedPtr & node,
  const rclcpp::CallbackGroup::SharedPtr & group, const rclcpp::Logger & logger)
: logger_(logger)
{
  executor_.add_callback_group(group, node);
  thread_ = std::thread([this, end = end_.get_future().share()] {receive(end);});
}

Receiver::~Receiver()
{
  end_.set_value();  // cancelling alone is lost on an executor that does not spin yet
  executor_.cancel();
  thread_.join();
}

void Receiver::receive(const std::shared_future<void> & end)
{
  const auto spin = [this, &end] {executor_.spin_until_future_complete(end);};
  const auto has_ended = [&end] {
      return end.wait_for(std::chrono::milliseconds(10)) == std::future_status::ready;
    };
  while (!guarded(logger_, "A message was not taken", spin) && !has_ended()) {
  }
}

}  // namespace PACKAGE_NAME
