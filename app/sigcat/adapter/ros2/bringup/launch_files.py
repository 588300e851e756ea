"""Launch files: nodes brought through their transitions, the same in XML, and all nodes in one container."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.ros2.bringup.graph import in_order_of_activation
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import Text

_TEMPLATES = {
    ".launch.py": "launch.py.j2",
    ".launch.xml": "launch.xml.j2",
    "_container.launch.py": "container_launch.py.j2",
}
"""Templates by what the names of their files end with."""


class _Launch(NamedTuple):
    rights: Text
    name: str
    """Name of the package."""
    namespace: str
    has_bond: bool
    nodes: Sequence[NodePlan]
    """In the order of activation."""


def launch_files(workspace: WorkspacePlan) -> Iterator[GeneratedFile]:
    """The files, by their names in the package."""
    name = workspace.name
    nodes = in_order_of_activation(workspace)
    plan = _Launch(rights(workspace.package), name, workspace.namespace.strip("/"), workspace.has_bond, nodes)
    for ending, template in _TEMPLATES.items():
        text = rendered(f"adapter/ros2/bringup/{template}", plan)
        yield GeneratedFile(f"launch/{name}{ending}", text.encode())
