"""The header of a node."""

from collections.abc import Iterable

from sigcat.adapter.ros2.cpp.names import guard, header_of
from sigcat.adapter.ros2.cpp.node.node_calls import stems_of
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, Publisher, Subscription, WorkspacePlan
from sigcat.adapter.templates import rendered


def node_header(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole header."""
    return rendered(
        "adapter/ros2/cpp/node/node.hpp.j2",
        rights=rights(workspace.package),
        node=node,
        guard=guard(workspace, node.stem),
        headers=_headers(node, workspace),
        package=workspace.name,
        interfaces=workspace.interfaces,
        has_messages=has_messages(node, node.publishers),
        stems=stems_of(node),  # of the names that it has for calls
        has_taken_callback=workspace.release != "humble",
        has_deadline=node.core.has_deadline,
        has_bond=workspace.has_bond,
    )


def has_messages(node: NodePlan, ends: Iterable[Publisher | Subscription]) -> bool:
    """Whether a message of the set is among those of some topics."""
    return any(node.is_own(each.message) for each in ends)


def _headers(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    messages = {each.message for each in node.publishers} | {each.service for each in (*node.offered, *node.used)}
    own = ["clock", "diagnostics", "receiver", "topics"]
    own += [*(["storage"] if node.core.is_stored else []), *(["watch"] if node.core.has_deadline else [])]
    headers = [header_of(each) for each in {*messages, node.step_service}]
    headers += [f"{workspace.name}/{each}.hpp" for each in own]
    headers += ["diagnostic_msgs/msg/diagnostic_array.hpp", "rclcpp/rclcpp.hpp", "rclcpp_lifecycle/lifecycle_node.hpp"]
    return sorted(headers)
