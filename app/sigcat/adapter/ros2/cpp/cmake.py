"""CMakeLists.txt of the package."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.core_files import RUNTIME_SOURCE
from sigcat.adapter.ros2.cpp.names import bridge_source
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.names import snake_case

_OWN = {"builtin_interfaces", "diagnostic_msgs", "rcl_interfaces"}
"""Packages of messages that nodes use, whatever their functions are."""


class _Node(NamedTuple):
    name: str
    stem: str
    type: str
    function: str
    folder: str
    """Default of the setting, below `code`."""
    setting: str
    """Variable with the folder of the code."""
    core: str
    """Library of the core."""
    component: str
    """Library of the component."""
    executable: str
    core_files: Sequence[str]
    sources: Sequence[str]
    """Paths below the folder of the code, as those of the include folders."""
    include_folders: Sequence[str]
    definitions: Sequence[str]


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
        nodes=[*map(_node, workspace.nodes)],
        # Packages whose headers those of the nodes include.
        exported=sorted({*own, workspace.interfaces, *workspace.message_packages}),
    )


def _node(node: NodePlan) -> _Node:
    code = node.core.code
    return _Node(
        name=node.name,
        stem=node.stem,
        type=node.type,
        function=node.core.function,
        folder=snake_case(node.core.function),
        setting=node.core.code_setting,
        core=node.core_library,
        component=node.component_library,
        executable=node.executable,
        core_files=(node.core.source_file, RUNTIME_SOURCE, bridge_source(node)),
        sources=code.sources,
        include_folders=code.include_folders,
        definitions=code.definitions,
    )
