#include "eco_control_baseline/cyclic_node.hpp"

#include <chrono>
#include <memory>
#include <mutex>
#include <string>

namespace eco_control_baseline
{

CyclicNode::CyclicNode(const std::string & name, uint64_t period, uint64_t offset)
: LifecycleNode(name), period_(period), offset_(offset),
  receiving_(create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive))
{
  declare_parameter<bool>("lock_step", false);
}

CyclicNode::~CyclicNode() {stop();}

CyclicNode::CallbackReturn CyclicNode::on_configure(const rclcpp_lifecycle::State & /* state */)
{
  is_in_lock_step_ = get_parameter("lock_step").as_bool();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    time_ = received_ = sent_ = 0;
    is_on_ = false;
    initialize();
  }
  connect();
  if (is_in_lock_step_) {
    service_ = create_service<Step>(
      "~/step", [this](
        const std::shared_ptr<Step::Request> request, std::shared_ptr<Step::Response> response) {
        step_to(*request, *response);
      });
  }
  return CallbackReturn::SUCCESS;
}

CyclicNode::CallbackReturn CyclicNode::on_activate(const rclcpp_lifecycle::State & state)
{
  LifecycleNode::on_activate(state);
  const std::lock_guard<std::mutex> lock(mutex_);
  begin_ = std::chrono::steady_clock::now();
  next_ = offset_;
  is_running_ = true;
  set_on(is_on_);
  start(current());
  if (!is_in_lock_step_) {
    thread_ = std::thread([this] {run();});
  }
  return CallbackReturn::SUCCESS;
}

CyclicNode::CallbackReturn CyclicNode::on_deactivate(const rclcpp_lifecycle::State & state)
{
  stop();
  return LifecycleNode::on_deactivate(state);
}

CyclicNode::CallbackReturn CyclicNode::on_cleanup(const rclcpp_lifecycle::State & /* state */)
{
  service_.reset();
  subscriptions_.clear();
  disconnect();
  const std::lock_guard<std::mutex> lock(mutex_);
  terminate();
  return CallbackReturn::SUCCESS;
}

void CyclicNode::set_on(bool is_on)
{
  if (is_on && !is_on_) {
    entered_ = current();
  }
  is_on_ = is_on;
}

uint64_t CyclicNode::current() const
{
  if (is_in_lock_step_ || !is_running_) {
    return time_;
  }
  const std::chrono::nanoseconds since = std::chrono::steady_clock::now() - begin_;
  return static_cast<uint64_t>(since.count());
}

void CyclicNode::tell(
  const std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<eco_control_interfaces::msg::ErrorStatus>> & publisher,
  uint8_t status)
{
  eco_control_interfaces::msg::ErrorStatus message;
  message.status = status;
  send(publisher, message);
}

void CyclicNode::run()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (is_running_) {
    changed_.wait_until(
      lock, begin_ + std::chrono::nanoseconds(next_), [this] {
        return !is_running_ || current() >= next_;
      });
    if (is_running_) {
      run_due();
    }
  }
}

// A late call runs once.
void CyclicNode::run_due()
{
  const uint64_t now = current();
  if (now < next_) {
    return;
  }
  if (is_on_) {
    step(now);
  }
  while (next_ <= now) {
    next_ += period_;
  }
}

void CyclicNode::stop()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_running_ = false;
  }
  changed_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void CyclicNode::step_to(const Step::Request & request, Step::Response & response)
{
  std::unique_lock<std::mutex> lock(mutex_);
  response.success = changed_.wait_for(
    lock, std::chrono::seconds(10), [this, &request] {return received_ >= request.received;});
  if (response.success && is_running_) {
    run_due();
    time_ = request.time;
  }
  response.received = received_;
  response.sent = sent_;
}

int run_node(int argc, char ** argv, const std::function<std::shared_ptr<CyclicNode>()> & make)
{
  rclcpp::init(argc, argv);
  {
    const auto node = make();
    rclcpp::executors::MultiThreadedExecutor executor(rclcpp::ExecutorOptions(), 2);
    executor.add_node(node->get_node_base_interface());
    executor.spin();
    executor.remove_node(node->get_node_base_interface());
  }
  rclcpp::shutdown();
  return 0;
}

}  // namespace eco_control_baseline
