// round_trip COUNT: brings the node to life, sends it COUNT speeds at 1 kHz, each after the answer to the one before, and prints
// the median of the microseconds from sending to hearing, and what the node last told of its adapter, if it tells.

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "diagnostic_msgs/msg/diagnostic_array.hpp"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "rclcpp/rclcpp.hpp"
#include "reflex_interfaces/msg/reflex_half.hpp"
#include "reflex_interfaces/msg/reflex_speed.hpp"

using Clock = std::chrono::steady_clock;
using diagnostic_msgs::msg::DiagnosticArray;
using lifecycle_msgs::srv::ChangeState;
using reflex_interfaces::msg::ReflexHalf;
using reflex_interfaces::msg::ReflexSpeed;

class RoundTrip : public rclcpp::Node
{
public:
  RoundTrip()
  : Node("round_trip")
  {
    const rclcpp::QoS quality = rclcpp::QoS(rclcpp::KeepLast(1)).best_effort();
    publisher_ = create_publisher<ReflexSpeed>("vehicle/reflex/speed", quality);
    subscription_ = create_subscription<ReflexHalf>(
      "vehicle/reflex/half", quality, [this](const ReflexHalf & message) {
        const std::lock_guard<std::mutex> lock(mutex_);
        heard_ = message.half;
        changed_.notify_one();
      });
    diagnostics_ = create_subscription<DiagnosticArray>(
      "/diagnostics", rclcpp::QoS(10), [this](const DiagnosticArray & told) {note(told);});
    change_ = create_client<ChangeState>("reflex/change_state");
  }

  void change(uint8_t transition)
  {
    if (!change_->wait_for_service(std::chrono::seconds(20))) {
      throw std::runtime_error("there is no node");
    }
    auto request = std::make_shared<ChangeState::Request>();
    request->transition.id = transition;
    auto future = change_->async_send_request(request).future;
    if (future.wait_for(std::chrono::seconds(20)) != std::future_status::ready || !future.get()->success) {
      throw std::runtime_error("the node does not come to life");
    }
  }

  // Seconds from sending to hearing; negative if the answer does not come.
  double trip(float speed)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    ReflexSpeed message;
    message.speed = speed;
    const auto begin = Clock::now();
    publisher_->publish(message);
    const bool has_come = changed_.wait_for(
      lock, std::chrono::milliseconds(500), [&] {return heard_ > speed * 0.49F && heard_ < speed * 0.51F;});
    return has_come ? std::chrono::duration<double>(Clock::now() - begin).count() : -1.0;
  }

  std::string adapter()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return adapter_;
  }

private:
  void note(const DiagnosticArray & told)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto & status : told.status) {
      for (const auto & value : status.values) {
        if (value.key == "t_adapter [us]") {
          adapter_ = value.value;
        }
      }
    }
  }

  rclcpp::Publisher<ReflexSpeed>::SharedPtr publisher_;
  rclcpp::Subscription<ReflexHalf>::SharedPtr subscription_;
  rclcpp::Subscription<DiagnosticArray>::SharedPtr diagnostics_;
  rclcpp::Client<ChangeState>::SharedPtr change_;
  std::mutex mutex_;
  std::condition_variable changed_;
  float heard_ = 0.0F;
  std::string adapter_ = "-";
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const int count = std::atoi(argv[1]);
  auto node = std::make_shared<RoundTrip>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node->get_node_base_interface());
  std::thread thread([&executor] {executor.spin();});
  node->change(1);
  node->change(3);
  std::vector<double> times;
  int missing = 0;
  for (int at = 0; at < count && missing < count; ) {
    const double taken = node->trip(100.0F + static_cast<float>((at * 7) % 10) * 10.0F);
    if (taken < 0.0) {
      ++missing;
    } else {
      times.push_back(taken);
      ++at;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1200));
  std::nth_element(times.begin(), times.begin() + static_cast<long>(times.size() / 2), times.end());
  std::printf("%.3f %s %d\n", times[times.size() / 2] * 1e6, node->adapter().c_str(), missing);
  executor.cancel();
  thread.join();
  rclcpp::shutdown();
  return 0;
}
