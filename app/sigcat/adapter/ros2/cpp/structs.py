"""Structs of messages and of the core, copied member by member."""

from sigcat.adapter.ros2.cpp.names import guard, header_of
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered


def structs_header(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole header."""
    messages = [header_of(pair.message) for pair in node.structs]
    return rendered(
        "adapter/ros2/cpp/structs.hpp.j2",
        rights=rights(workspace.package),
        name=node.name,
        guard=guard(workspace, f"{node.name}_structs"),
        package=workspace.name,
        headers=sorted([node.core.header_file, f"{workspace.name}/values.hpp", *messages]),
        pairs=node.structs,
    )
