#include "rclcpp_lifecycle/lifecycle_node.hpp"

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "lifecycle_msgs/msg/state.hpp"
#include "lifecycle_msgs/msg/transition_description.hpp"
#include "lifecycle_msgs/msg/transition_event.h"
#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_available_states.hpp"
#include "lifecycle_msgs/srv/get_available_transitions.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "rcl/error_handling.h"
#include "rcl_lifecycle/rcl_lifecycle.h"
#include "rclcpp/exceptions.hpp"
#include "rosidl_typesupport_cpp/service_type_support.hpp"

namespace rclcpp_lifecycle
{

using node_interfaces::LifecycleNodeInterface;
using CallbackReturn = LifecycleNodeInterface::CallbackReturn;
using lifecycle_msgs::msg::Transition;
using StateId = lifecycle_msgs::msg::State;

namespace detail
{

namespace
{

using lifecycle_msgs::srv::ChangeState;
using lifecycle_msgs::srv::GetAvailableStates;
using lifecycle_msgs::srv::GetAvailableTransitions;
using lifecycle_msgs::srv::GetState;
using Descriptions = std::vector<lifecycle_msgs::msg::TransitionDescription>;

Descriptions described(const rcl_lifecycle_transition_t * transitions, unsigned int count)
{
  Descriptions found(count);
  for (unsigned int at = 0; at < count; ++at) {
    found[at].transition.id = static_cast<uint8_t>(transitions[at].id);
    found[at].transition.label = transitions[at].label;
    found[at].start_state.id = static_cast<uint8_t>(transitions[at].start->id);
    found[at].start_state.label = transitions[at].start->label;
    found[at].goal_state.id = static_cast<uint8_t>(transitions[at].goal->id);
    found[at].goal_state.label = transitions[at].goal->label;
  }
  return found;
}

const char * label_of(CallbackReturn result)
{
  switch (result) {
    case CallbackReturn::SUCCESS: return rcl_lifecycle_transition_success_label;
    case CallbackReturn::FAILURE: return rcl_lifecycle_transition_failure_label;
    case CallbackReturn::ERROR: return rcl_lifecycle_transition_error_label;
  }
  return rcl_lifecycle_transition_error_label;
}

}  // namespace

/// The state machine of rcl_lifecycle, its services, and the callbacks of its node.
class StateMachine
{
public:
  StateMachine(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base, LifecycleNodeInterface & node);
  ~StateMachine();

  const State & current() const {return current_;}
  CallbackReturn change(uint8_t transition);

private:
  bool begin(uint8_t transition);
  void end(CallbackReturn result);
  void note_state();
  CallbackReturn call(const State & previous);
  CallbackReturn call_of_state(const State & previous);
  void change_state(const ChangeState::Request & request, ChangeState::Response & response);
  void serve();
  template<typename ServiceT>
  void serve(
    rcl_service_t & service,
    std::function<void(const typename ServiceT::Request &, typename ServiceT::Response &)> callback);

  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base_;
  LifecycleNodeInterface & node_;
  std::recursive_mutex mutex_;
  rcl_lifecycle_state_machine_t machine_;
  State current_{StateId::PRIMARY_STATE_UNCONFIGURED, "unconfigured"};
  std::vector<std::shared_ptr<rclcpp::detail::Waitable>> services_;
};

StateMachine::StateMachine(
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base, LifecycleNodeInterface & node)
: base_(std::move(base)), node_(node), machine_(rcl_lifecycle_get_zero_initialized_state_machine())
{
  auto options = rcl_lifecycle_get_default_state_machine_options();
  using rosidl_typesupport_cpp::get_service_type_support_handle;
  rclcpp::detail::check(
    rcl_lifecycle_state_machine_init(
      &machine_, base_->get_shared_rcl_node_handle().get(),
      ROSIDL_GET_MSG_TYPE_SUPPORT(lifecycle_msgs, msg, TransitionEvent),
      get_service_type_support_handle<ChangeState>(), get_service_type_support_handle<GetState>(),
      get_service_type_support_handle<GetAvailableStates>(),
      get_service_type_support_handle<GetAvailableTransitions>(),
      get_service_type_support_handle<GetAvailableTransitions>(), &options), "state machine");
  serve();
}

StateMachine::~StateMachine()
{
  services_.clear();
  const auto node = base_->get_shared_rcl_node_handle();
  if (rcl_lifecycle_state_machine_fini(&machine_, node.get()) != RCL_RET_OK) {
    rcl_reset_error();
  }
}

template<typename ServiceT>
void StateMachine::serve(
  rcl_service_t & service,
  std::function<void(const typename ServiceT::Request &, typename ServiceT::Response &)> callback)
{
  auto made = std::make_shared<rclcpp::Service<ServiceT>>(
    &service, [callback](auto request, auto response) {callback(*request, *response);});
  base_->add(made, nullptr);
  services_.push_back(made);
}

void StateMachine::serve()
{
  auto & interface = machine_.com_interface;
  serve<ChangeState>(interface.srv_change_state, [this](const auto & request, auto & response) {
      change_state(request, response);
    });
  serve<GetState>(interface.srv_get_state, [this](const auto &, auto & response) {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      response.current_state.id = static_cast<uint8_t>(machine_.current_state->id);
      response.current_state.label = machine_.current_state->label;
    });
  serve<GetAvailableStates>(
    interface.srv_get_available_states, [this](const auto &, auto & response) {
      const auto & map = machine_.transition_map;
      response.available_states.resize(map.states_size);
      for (unsigned int at = 0; at < map.states_size; ++at) {
        response.available_states[at].id = static_cast<uint8_t>(map.states[at].id);
        response.available_states[at].label = map.states[at].label;
      }
    });
  serve<GetAvailableTransitions>(
    interface.srv_get_available_transitions, [this](const auto &, auto & response) {
      const std::lock_guard<std::recursive_mutex> lock(mutex_);
      response.available_transitions = described(
        machine_.current_state->valid_transitions, machine_.current_state->valid_transition_size);
    });
  serve<GetAvailableTransitions>(
    interface.srv_get_transition_graph, [this](const auto &, auto & response) {
      response.available_transitions = described(
        machine_.transition_map.transitions, machine_.transition_map.transitions_size);
    });
}

void StateMachine::change_state(
  const ChangeState::Request & request, ChangeState::Response & response)
{
  uint8_t id = request.transition.id;
  if (!request.transition.label.empty()) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    const auto * found = rcl_lifecycle_get_transition_by_label(
      machine_.current_state, request.transition.label.c_str());
    if (!found) {
      response.success = false;
      return;
    }
    id = static_cast<uint8_t>(found->id);
  }
  response.success = change(id) == CallbackReturn::SUCCESS;
}

CallbackReturn StateMachine::change(uint8_t transition)
{
  const State previous = current_;
  if (!begin(transition)) {
    return CallbackReturn::ERROR;
  }
  const CallbackReturn result = call(previous);
  end(result);
  if (result == CallbackReturn::ERROR) {
    end(call(previous));
  }
  return result;
}

bool StateMachine::begin(uint8_t transition)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (rcl_lifecycle_trigger_transition_by_id(&machine_, transition, true) == RCL_RET_OK) {
    note_state();
    return true;
  }
  const rclcpp::Logger logger(base_->get_logger_name());
  RCLCPP_ERROR(
    logger, "Unable to start transition %u from current state %s: %s", transition,
    machine_.current_state->label, rcl_get_error_string().str);
  rcl_reset_error();
  return false;
}

void StateMachine::end(CallbackReturn result)
{
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const char * label = label_of(result);
  if (rcl_lifecycle_trigger_transition_by_label(&machine_, label, true) != RCL_RET_OK) {
    const rclcpp::Logger logger(base_->get_logger_name());
    RCLCPP_ERROR(logger, "Failed to finish a transition: %s", rcl_get_error_string().str);
    rcl_reset_error();
  }
  note_state();
}

void StateMachine::note_state()
{
  current_ = State(static_cast<uint8_t>(machine_.current_state->id), machine_.current_state->label);
}

CallbackReturn StateMachine::call(const State & previous)
{
  try {
    return call_of_state(previous);
  } catch (const std::exception & exception) {
    const rclcpp::Logger logger(base_->get_logger_name());
    RCLCPP_ERROR(logger, "Caught exception in a callback of a transition: %s", exception.what());
    return CallbackReturn::ERROR;
  }
}

CallbackReturn StateMachine::call_of_state(const State & previous)
{
  switch (machine_.current_state->id) {
    case StateId::TRANSITION_STATE_CONFIGURING: return node_.on_configure(previous);
    case StateId::TRANSITION_STATE_CLEANINGUP: return node_.on_cleanup(previous);
    case StateId::TRANSITION_STATE_SHUTTINGDOWN: return node_.on_shutdown(previous);
    case StateId::TRANSITION_STATE_ACTIVATING: return node_.on_activate(previous);
    case StateId::TRANSITION_STATE_DEACTIVATING: return node_.on_deactivate(previous);
    default: return node_.on_error(previous);
  }
}

}  // namespace detail

LifecycleNode::LifecycleNode(
  const std::string & name, const std::string & name_space, const rclcpp::NodeOptions & options)
: NodeParts(name, name_space, options),
  machine_(std::make_unique<detail::StateMachine>(base_, *this))
{
}

LifecycleNode::~LifecycleNode() = default;

const State & LifecycleNode::get_current_state() const
{
  return machine_->current();
}

const State & LifecycleNode::trigger_transition(uint8_t transition)
{
  machine_->change(transition);
  return machine_->current();
}

const State & LifecycleNode::configure()
{
  return trigger_transition(Transition::TRANSITION_CONFIGURE);
}

const State & LifecycleNode::cleanup()
{
  return trigger_transition(Transition::TRANSITION_CLEANUP);
}

const State & LifecycleNode::activate()
{
  return trigger_transition(Transition::TRANSITION_ACTIVATE);
}

const State & LifecycleNode::deactivate()
{
  return trigger_transition(Transition::TRANSITION_DEACTIVATE);
}

const State & LifecycleNode::shutdown()
{
  switch (get_current_state().id()) {
    case StateId::PRIMARY_STATE_ACTIVE:
      return trigger_transition(Transition::TRANSITION_ACTIVE_SHUTDOWN);
    case StateId::PRIMARY_STATE_INACTIVE:
      return trigger_transition(Transition::TRANSITION_INACTIVE_SHUTDOWN);
    default:
      return trigger_transition(Transition::TRANSITION_UNCONFIGURED_SHUTDOWN);
  }
}

CallbackReturn LifecycleNode::on_activate(const State &)
{
  for (const auto & weak : managed_) {
    if (const auto entity = weak.lock()) {
      entity->on_activate();
    }
  }
  return CallbackReturn::SUCCESS;
}

CallbackReturn LifecycleNode::on_deactivate(const State &)
{
  for (const auto & weak : managed_) {
    if (const auto entity = weak.lock()) {
      entity->on_deactivate();
    }
  }
  return CallbackReturn::SUCCESS;
}

}  // namespace rclcpp_lifecycle
