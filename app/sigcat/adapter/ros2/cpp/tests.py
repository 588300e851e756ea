"""Tests of the package, which `colcon test` runs: the life of each node, its parameters, lock-step, what it keeps."""

from sigcat.adapter.ros2.cpp.names import header_of
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered


def node_test(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source of a node's tests."""
    return rendered(
        "adapter/ros2/cpp/test_node.cpp.j2",
        rights=rights(workspace.package),
        headers=_headers(node, workspace),
        interfaces=workspace.interfaces,
        package=workspace.name,
        node=node,
        refused=[each for each in node.settable if not each.is_read_only and each.high is not None],
        beyond=_beyond,
        cycle=min(
            (step.cycle for step in node.core.steps if step.cycle), default=10**7
        ),  # nanoseconds between two steps
    )


def _headers(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    headers = [f"{workspace.name}/{node.stem}.hpp", header_of(node.step_service), "lifecycle_msgs/msg/state.hpp"]
    headers += ["rclcpp/rclcpp.hpp", *([f"{workspace.name}/storage.hpp"] if node.core.is_stored else [])]
    return sorted(headers)


def _beyond(parameter: NodeParameter) -> str:
    """A value above the range of a parameter."""
    assert parameter.high is not None
    if parameter.type != "double":
        return f"int64_t{{{int(parameter.high) + 1}}}"
    value = f"{parameter.high + 1}"
    return value if "." in value else f"{value}.0"


def launch_test(workspace: WorkspacePlan) -> str:
    """The launch file brings every node to its active state."""
    nodes = [f"{workspace.namespace.rstrip('/')}/{node.name}" for node in workspace.nodes]
    return rendered(
        "adapter/ros2/cpp/test_launch.py.j2",
        package=workspace.name,
        nodes=nodes,  # their full names
    )
