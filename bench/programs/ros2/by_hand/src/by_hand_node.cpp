// What one would write by hand: callbacks store, and a thread of its own calls the function and publishes.

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "reflex.h"
#include "reflex_interfaces/msg/reflex_half.hpp"
#include "reflex_interfaces/msg/reflex_speed.hpp"

using reflex_interfaces::msg::ReflexHalf;
using reflex_interfaces::msg::ReflexSpeed;

class ByHandNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  ByHandNode()
  : LifecycleNode("reflex") {}
  ~ByHandNode() override {stop();}

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    const rclcpp::QoS last(rclcpp::KeepLast(1));
    publisher_ = create_publisher<ReflexHalf>(
      "vehicle/reflex/half", rclcpp::QoS(last).reliable().transient_local());
    subscription_ = create_subscription<ReflexSpeed>(
      "vehicle/reflex/speed", rclcpp::QoS(last).best_effort(), [this](const ReflexSpeed & message) {
        {
          const std::lock_guard<std::mutex> lock(mutex_);
          speed_ = message.speed;
          has_come_ = true;
        }
        changed_.notify_one();
      });
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State & previous) override
  {
    LifecycleNode::on_activate(previous);
    thread_ = std::thread([this] {run();});
    return CallbackReturn::SUCCESS;
  }

private:
  void run()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] {return has_come_ || is_stopped_;});
      if (is_stopped_) {
        return;
      }
      has_come_ = false;
      reflex_speed = speed_ / 3.6F;
      lock.unlock();
      ReflexHalf message;
      message.stamp = now();
      reflex_step();
      message.half = reflex_half * 3.6F;
      publisher_->publish(message);
      lock.lock();
    }
  }

  void stop()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_stopped_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  rclcpp_lifecycle::LifecyclePublisher<ReflexHalf>::SharedPtr publisher_;
  rclcpp::Subscription<ReflexSpeed>::SharedPtr subscription_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
  float speed_ = 0.0F;
  bool has_come_ = false;
  bool is_stopped_ = false;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  {
    auto node = std::make_shared<ByHandNode>();
    rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
    executor.add_node(node->get_node_base_interface());
    executor.spin();
    executor.remove_node(node->get_node_base_interface());
  }
  rclcpp::shutdown();
  return 0;
}
