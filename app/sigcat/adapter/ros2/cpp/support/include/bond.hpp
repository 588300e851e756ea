// The bond of a node with its lifecycle manager.

#ifndef PACKAGE_GUARD__BOND_HPP_
#define PACKAGE_GUARD__BOND_HPP_

#include <memory>

#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace PACKAGE_NAME
{

/// Sends heartbeats of an active node, until the returned pointer is reset. It is empty if the
/// package was built without bondcpp.
std::shared_ptr<void> bond_with_manager(const rclcpp_lifecycle::LifecycleNode::SharedPtr & node);

}  // namespace PACKAGE_NAME

#endif  // PACKAGE_GUARD__BOND_HPP_
