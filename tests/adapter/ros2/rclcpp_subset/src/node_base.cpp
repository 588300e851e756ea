#include "rclcpp/node_base.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rcl/error_handling.h"
#include "rcl/logging.h"
#include "rcl/logging_rosout.h"
#include "rcl/node_options.h"
#include "rclcpp/exceptions.hpp"

namespace rclcpp
{

void CallbackGroup::add(const std::shared_ptr<detail::Waitable> & waitable)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waitables_.push_back(waitable);
    if (listener_) {
      listener_();
    }
  }
  changed_();
}

bool CallbackGroup::set_listener(std::function<void()> listener)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (listener_) {
    return false;
  }
  listener_ = std::move(listener);
  return true;
}

void CallbackGroup::clear_listener()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  listener_ = nullptr;
}

CallbackGroup::Waitables CallbackGroup::waitables()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  Waitables found;
  const auto gone = [&found](const std::weak_ptr<detail::Waitable> & each) {
      auto waitable = each.lock();
      if (waitable) {
        found.push_back(std::move(waitable));
      }
      return each.expired();
    };
  waitables_.erase(
    std::remove_if(waitables_.begin(), waitables_.end(), gone), waitables_.end());
  return found;
}

bool CallbackGroup::begin()
{
  return type_ == CallbackGroupType::Reentrant || !busy_.exchange(true);
}

void CallbackGroup::end()
{
  busy_ = false;
}

namespace node_interfaces
{

namespace
{

rcl_arguments_t arguments_of(const NodeOptions & options)
{
  std::vector<const char *> texts;
  for (const std::string & text : options.arguments()) {
    texts.push_back(text.c_str());
  }
  rcl_arguments_t arguments = rcl_get_zero_initialized_arguments();
  detail::check(
    rcl_parse_arguments(
      static_cast<int>(texts.size()), texts.data(), rcl_get_default_allocator(), &arguments),
    "arguments of the node");
  return arguments;
}

std::shared_ptr<rcl_node_t> make_node(
  const std::string & name, const std::string & name_space, const NodeOptions & options,
  const std::shared_ptr<detail::Context> & context)
{
  auto node = std::make_unique<rcl_node_t>(rcl_get_zero_initialized_node());
  rcl_node_options_t settings = rcl_node_get_default_options();
  settings.arguments = arguments_of(options);
  const rcl_ret_t made =
    rcl_node_init(node.get(), name.c_str(), name_space.c_str(), context->handle(), &settings);
  detail::check(rcl_node_options_fini(&settings), "options of the node");
  detail::check(made, "node");
  if (rcl_logging_rosout_enabled()) {
    detail::check(rcl_logging_rosout_init_publisher_for_node(node.get()), "/rosout");
  }
  return {node.release(), [context](rcl_node_t * gone) {
      if (rcl_logging_rosout_enabled() &&
        rcl_logging_rosout_fini_publisher_for_node(gone) != RCL_RET_OK)
      {
        rcl_reset_error();
      }
      if (rcl_node_fini(gone) != RCL_RET_OK) {
        rcl_reset_error();
      }
      delete gone;
    }};
}

}  // namespace

NodeBaseInterface::NodeBaseInterface(
  const std::string & name, const std::string & name_space, const NodeOptions & options)
: context_(detail::context()),
  handle_(make_node(name, name_space, options, context_)),
  default_group_(create_callback_group(CallbackGroupType::MutuallyExclusive))
{
}

const char * NodeBaseInterface::get_fully_qualified_name() const
{
  return rcl_node_get_fully_qualified_name(handle_.get());
}

CallbackGroup::SharedPtr NodeBaseInterface::create_callback_group(
  CallbackGroupType type, bool automatically_add_to_executor_with_node)
{
  auto group = std::make_shared<CallbackGroup>(type, [this] {tell();});
  if (automatically_add_to_executor_with_node) {
    const std::lock_guard<std::mutex> lock(mutex_);
    groups_.push_back(group);
  }
  return group;
}

void NodeBaseInterface::add(
  const std::shared_ptr<detail::Waitable> & waitable, const CallbackGroup::SharedPtr & group)
{
  (group ? group : default_group_)->add(waitable);
}

std::vector<CallbackGroup::SharedPtr> NodeBaseInterface::callback_groups()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<CallbackGroup::SharedPtr> found;
  for (const CallbackGroup::WeakPtr & each : groups_) {
    if (auto group = each.lock()) {
      found.push_back(std::move(group));
    }
  }
  return found;
}

bool NodeBaseInterface::set_listener(std::function<void()> listener)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (listener_) {
    return false;
  }
  listener_ = std::move(listener);
  return true;
}

void NodeBaseInterface::clear_listener()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  listener_ = nullptr;
}

void NodeBaseInterface::tell()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (listener_) {
    listener_();
  }
}

}  // namespace node_interfaces
}  // namespace rclcpp
