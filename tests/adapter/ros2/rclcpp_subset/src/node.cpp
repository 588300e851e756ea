#include "rclcpp/node.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl/graph.h"
#include "rclcpp/exceptions.hpp"
#include "time_source.hpp"

namespace rclcpp::detail
{

TimeSource::TimeSource(node_interfaces::NodeBaseInterface::SharedPtr node, Clock::SharedPtr clock)
: node_(std::move(node)), clock_(std::move(clock)),
  group_(node_->create_callback_group(CallbackGroupType::MutuallyExclusive, false))
{
}

TimeSource::~TimeSource()
{
  use(false);
}

void TimeSource::use(bool is_simulated)
{
  if (is_simulated == thread_.joinable()) {
    return;
  }
  if (!is_simulated) {
    executor_->cancel();
    thread_.join();
    executor_.reset();
    subscription_.reset();
    const std::lock_guard<std::mutex> lock(clock_->get_clock_mutex());
    check(rcl_disable_ros_time_override(clock_->get_clock_handle()), "time");
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(clock_->get_clock_mutex());
    check(rcl_enable_ros_time_override(clock_->get_clock_handle()), "time");
  }
  const auto set = [this](const rosgraph_msgs::msg::Clock & message) {
      const int64_t time = int64_t{message.clock.sec} * 1'000'000'000 + message.clock.nanosec;
      const std::lock_guard<std::mutex> lock(clock_->get_clock_mutex());
      check(rcl_set_ros_time_override(clock_->get_clock_handle(), time), "time");
    };
  subscription_ = std::make_shared<Subscription<rosgraph_msgs::msg::Clock>>(
    *node_, "/clock", QoS(KeepLast(1)).best_effort(), set, SubscriptionOptions{group_, {}});
  group_->add(subscription_);
  executor_ = std::make_unique<executors::SingleThreadedExecutor>();
  executor_->add_callback_group(group_, node_);
  thread_ = std::thread([this] {executor_->spin();});
  while (!executor_->is_spinning()) {
    std::this_thread::yield();  // an earlier cancel would be lost
  }
}

NodeParts::NodeParts(
  const std::string & name, const std::string & name_space, const NodeOptions & options)
: base_(std::make_shared<node_interfaces::NodeBaseInterface>(name, name_space, options)),
  clock_(std::make_shared<Clock>(RCL_ROS_TIME)),
  parameters_(std::make_unique<node_interfaces::NodeParameters>(base_, clock_, options)),
  time_source_(std::make_unique<TimeSource>(base_, clock_))
{
  parameters_->after_set([this](const std::vector<Parameter> & parameters) {
      for (const Parameter & parameter : parameters) {
        if (parameter.get_name() == "use_sim_time") {
          time_source_->use(parameter.as_bool());
        }
      }
    });
  declare_parameter("use_sim_time", false);
}

NodeParts::~NodeParts() = default;

std::vector<Parameter> NodeParts::get_parameters(const std::vector<std::string> & names) const
{
  std::vector<Parameter> parameters;
  for (const std::string & name : names) {
    parameters.push_back(parameters_->get(name));
  }
  return parameters;
}

size_t NodeParts::count_publishers(const std::string & topic) const
{
  size_t count = 0;
  check(
    rcl_count_publishers(base_->get_shared_rcl_node_handle().get(), topic.c_str(), &count), topic.c_str());
  return count;
}

size_t NodeParts::count_subscribers(const std::string & topic) const
{
  size_t count = 0;
  check(
    rcl_count_subscribers(base_->get_shared_rcl_node_handle().get(), topic.c_str(), &count), topic.c_str());
  return count;
}

}  // namespace rclcpp::detail
