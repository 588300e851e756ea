// A lifecycle node with one cyclic call.

#ifndef ECO_CONTROL_BASELINE__CYCLIC_NODE_HPP_
#define ECO_CONTROL_BASELINE__CYCLIC_NODE_HPP_

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "eco_control_interfaces/msg/error_status.hpp"
#include "eco_control_interfaces/srv/step.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace eco_control_baseline
{

class CyclicNode : public rclcpp_lifecycle::LifecycleNode
{
public:
  CyclicNode(const std::string & name, uint64_t period, uint64_t offset);
  ~CyclicNode() override;

  CallbackReturn on_configure(const rclcpp_lifecycle::State & state) override;
  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override;
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State & state) override;
  CallbackReturn on_cleanup(const rclcpp_lifecycle::State & state) override;

protected:
  using Step = eco_control_interfaces::srv::Step;

  // All of them are called with the mutex held; times are in ns since activation.
  virtual void initialize() = 0;
  virtual void start(uint64_t now) = 0;
  virtual void step(uint64_t now) = 0;
  virtual void terminate() = 0;
  virtual void connect() = 0;
  virtual void disconnect() = 0;

  static rclcpp::QoS for_values() {return rclcpp::QoS(rclcpp::KeepLast(1)).best_effort();}
  static rclcpp::QoS for_states()
  {
    return rclcpp::QoS(rclcpp::KeepLast(1)).reliable().transient_local();
  }

  template<typename Message>
  void listen(
    const std::string & topic, const rclcpp::QoS & quality, std::function<void(const Message &)> take)
  {
    rclcpp::SubscriptionOptions options;
    options.callback_group = receiving_;
    subscriptions_.push_back(
      create_subscription<Message>(
        topic, quality, [this, take](const Message & message) {
          {
            const std::lock_guard<std::mutex> lock(mutex_);
            take(message);
            ++received_;
          }
          changed_.notify_all();
        }, options));
  }

  template<typename Message>
  void send(
    const std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<Message>> & publisher, Message & message)
  {
    message.stamp = is_in_lock_step_ ? rclcpp::Time(static_cast<int64_t>(time_)) : this->now();
    publisher->publish(message);
    ++sent_;
  }

  void tell(
    const std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<eco_control_interfaces::msg::ErrorStatus>> & publisher,
    uint8_t status);

  // Whether the mode includes the call, from now on.
  void set_on(bool is_on);
  uint64_t current() const;
  uint64_t entered() const {return entered_;}
  uint64_t next() const {return next_;}

private:
  void run();
  void run_due();
  void stop();
  void step_to(const Step::Request & request, Step::Response & response);

  const uint64_t period_;
  const uint64_t offset_;
  std::mutex mutex_;
  std::condition_variable changed_;
  rclcpp::CallbackGroup::SharedPtr receiving_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
  std::thread thread_;
  std::chrono::steady_clock::time_point begin_;
  uint64_t next_ = 0;
  uint64_t entered_ = 0;
  bool is_on_ = false;
  bool is_running_ = false;

  // Only for the comparison: a player sets the time.
  rclcpp::Service<Step>::SharedPtr service_;
  bool is_in_lock_step_ = false;
  uint64_t time_ = 0;
  uint64_t received_ = 0;
  uint64_t sent_ = 0;
};

int run_node(int argc, char ** argv, const std::function<std::shared_ptr<CyclicNode>()> & make);

}  // namespace eco_control_baseline

#endif  // ECO_CONTROL_BASELINE__CYCLIC_NODE_HPP_
