// A node of the user: CoreAcc, which also counts what it sends, and completes it.

#include <cstdint>
#include <memory>
#include <vector>

#include "eco_control/core_acc_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int32.hpp"

class Derived : public eco_control::CoreAccNode
{
public:
  explicit Derived(const rclcpp::NodeOptions & options)
  : CoreAccNode(options)
  {
    refusing_ = add_on_set_parameters_callback(
      [](const std::vector<rclcpp::Parameter> & parameters) {
        rcl_interfaces::msg::SetParametersResult result;
        result.successful = parameters.empty() || parameters[0].get_name() != "a_lat_max" ||
        parameters[0].as_double() < 5.0;
        return result;
      });
  }
  ~Derived() override {stop_calls();}

  CallbackReturn on_configure(const rclcpp_lifecycle::State & state) override
  {
    counted_ = create_publisher<std_msgs::msg::UInt32>("counted", rclcpp::QoS(10));
    return CoreAccNode::on_configure(state);
  }

protected:
  void complete_core_acc_cycle50_ms(
    eco_control_interfaces::msg::CoreAccCycle50ms & message) override
  {
    std_msgs::msg::UInt32 count;
    count.data = ++count_;
    counted_->publish(count);
    message.stamp.sec = 7;
  }

private:
  uint32_t count_ = 0;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr refusing_;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::UInt32>::SharedPtr counted_;
};

int main(int argc, char * argv[])
{
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<Derived>(rclcpp::NodeOptions());
  rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
  executor.add_node(node->get_node_base_interface());
  executor.spin();
  rclcpp::shutdown();
}
