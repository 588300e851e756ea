"""The main function of a node's own executable."""

from typing import NamedTuple

from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import AnyText


class _Main(NamedTuple):
    """Plan of the source."""

    rights: AnyText
    header: str
    package: str
    type: str
    name: str


def main_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source. Two threads beside the one that receives: one answers, one changes the state."""
    header = f"{workspace.name}/{node.stem}.hpp"
    plan = _Main(rights(workspace.package), header, workspace.name, node.type, node.name)
    return rendered("adapter/ros2/cpp/main.cpp.j2", plan)
