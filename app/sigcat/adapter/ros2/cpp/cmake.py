"""CMakeLists.txt of the package."""

from collections.abc import Sequence

from sigcat.adapter.core.core_files import RUNTIME_SOURCE
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.adapter.templates import rendered

_OWN = {"builtin_interfaces", "diagnostic_msgs", "rcl_interfaces"}
"""Packages of messages that nodes use, whatever their functions are."""


def cmake(workspace: WorkspacePlan, support: Sequence[str]) -> str:
    """CMakeLists.txt. `support` are sources that all nodes share."""
    own = {*_OWN, "Threads", "rclcpp", "rclcpp_components", "rclcpp_lifecycle"}
    return rendered(
        "adapter/ros2/cpp/CMakeLists.txt.j2",
        name=workspace.name,
        interfaces=workspace.interfaces,
        # Those that are not always needed.
        message_packages=[each for each in workspace.message_packages if each not in _OWN],
        support=support,
        has_bond=workspace.has_bond,
        nodes=workspace.nodes,
        runtime_source=RUNTIME_SOURCE,
        # Packages whose headers those of the nodes include.
        exported=sorted({*own, workspace.interfaces, *workspace.message_packages}),
    )
