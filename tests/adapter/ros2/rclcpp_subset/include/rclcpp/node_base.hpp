#ifndef RCLCPP__NODE_BASE_HPP_
#define RCLCPP__NODE_BASE_HPP_

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rcl/node.h"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/node_options.hpp"

namespace rclcpp::node_interfaces
{

/// The node of rcl, and the groups of its callbacks.
class NodeBaseInterface
{
public:
  using SharedPtr = std::shared_ptr<NodeBaseInterface>;

  NodeBaseInterface(
    const std::string & name, const std::string & name_space, const NodeOptions & options);

  const char * get_name() const {return rcl_node_get_name(handle_.get());}
  const char * get_namespace() const {return rcl_node_get_namespace(handle_.get());}
  const char * get_fully_qualified_name() const;
  const char * get_logger_name() const {return rcl_node_get_logger_name(handle_.get());}
  std::shared_ptr<rcl_node_t> get_shared_rcl_node_handle() const {return handle_;}
  std::shared_ptr<detail::Context> get_context() const {return context_;}

  CallbackGroup::SharedPtr create_callback_group(
    CallbackGroupType type, bool automatically_add_to_executor_with_node = true);
  CallbackGroup::SharedPtr get_default_callback_group() const {return default_group_;}

  /// Adds it to this group, or the default one.
  void add(const std::shared_ptr<detail::Waitable> & waitable, const CallbackGroup::SharedPtr & group);

  std::vector<CallbackGroup::SharedPtr> callback_groups();
  /// Who is told when there is more to wait for. One executor has a node; false if another one has it.
  bool set_listener(std::function<void()> listener);
  void clear_listener();

private:
  void tell();

  std::shared_ptr<detail::Context> context_;
  std::shared_ptr<rcl_node_t> handle_;
  std::mutex mutex_;
  std::function<void()> listener_;
  std::vector<CallbackGroup::WeakPtr> groups_;
  CallbackGroup::SharedPtr default_group_;
};

}  // namespace rclcpp::node_interfaces

#endif  // RCLCPP__NODE_BASE_HPP_
