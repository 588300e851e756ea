#include "PACKAGE_NAME/bond.hpp"

#include <memory>
#include <string>

#ifdef HAS_BONDCPP
#include "bondcpp/bond.hpp"
#endif
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace PACKAGE_NAME
{

#ifdef HAS_BONDCPP
std::shared_ptr<void> bond_with_manager(const rclcpp_lifecycle::LifecycleNode::SharedPtr & node)
{
  // The manager watches the node; the node does not end if the manager is late.
  const std::string & is_watched_only = bond::msg::Constants::DISABLE_HEARTBEAT_TIMEOUT_PARAM;
  if (!node->has_parameter(is_watched_only)) {
    node->declare_parameter(is_watched_only, true);
  }
  auto bond = std::make_shared<bond::Bond>("bond", node->get_name(), node);
  bond->setHeartbeatPeriod(0.1);
  bond->setHeartbeatTimeout(4.0);
  bond->start();
  return bond;
}
#else
std::shared_ptr<void> bond_with_manager(const rclcpp_lifecycle::LifecycleNode::SharedPtr &)
{
  return nullptr;
}
#endif

}  // namespace PACKAGE_NAME
