#ifndef RCLCPP_LIFECYCLE__LIFECYCLE_NODE_HPP_
#define RCLCPP_LIFECYCLE__LIFECYCLE_NODE_HPP_

#include <memory>
#include <string>
#include <vector>

#include "lifecycle_msgs/msg/transition.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"
#include "rclcpp_lifecycle/state.hpp"

namespace rclcpp_lifecycle
{

namespace detail
{

class StateMachine;

}  // namespace detail

namespace node_interfaces
{

class LifecycleNodeInterface
{
public:
  enum class CallbackReturn : uint8_t
  {
    SUCCESS = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_SUCCESS,
    FAILURE = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_FAILURE,
    ERROR = lifecycle_msgs::msg::Transition::TRANSITION_CALLBACK_ERROR,
  };

  virtual ~LifecycleNodeInterface() = default;

  virtual CallbackReturn on_configure(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_cleanup(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_shutdown(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_activate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_deactivate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_error(const State &) {return CallbackReturn::SUCCESS;}
};

}  // namespace node_interfaces

class LifecycleNode : public node_interfaces::LifecycleNodeInterface,
  public rclcpp::detail::NodeParts, public std::enable_shared_from_this<LifecycleNode>
{
public:
  using SharedPtr = std::shared_ptr<LifecycleNode>;

  explicit LifecycleNode(
    const std::string & name, const rclcpp::NodeOptions & options = rclcpp::NodeOptions())
  : LifecycleNode(name, "", options) {}
  LifecycleNode(
    const std::string & name, const std::string & name_space,
    const rclcpp::NodeOptions & options = rclcpp::NodeOptions());
  ~LifecycleNode() override;

  template<typename MessageT>
  std::shared_ptr<LifecyclePublisher<MessageT>> create_publisher(
    const std::string & topic, const rclcpp::QoS & qos, const rclcpp::PublisherOptions & options = {})
  {
    auto made = std::make_shared<LifecyclePublisher<MessageT>>(*base_, topic, qos, options);
    managed_.push_back(made);
    return made;
  }

  const State & get_current_state() const;
  const State & trigger_transition(uint8_t transition);
  const State & configure();
  const State & cleanup();
  const State & activate();
  const State & deactivate();
  const State & shutdown();

  /// Those of the base class activate and deactivate the publishers.
  CallbackReturn on_activate(const State & previous_state) override;
  CallbackReturn on_deactivate(const State & previous_state) override;

private:
  std::unique_ptr<detail::StateMachine> machine_;
  std::vector<std::weak_ptr<ManagedEntityInterface>> managed_;
};

}  // namespace rclcpp_lifecycle

#endif  // RCLCPP_LIFECYCLE__LIFECYCLE_NODE_HPP_
