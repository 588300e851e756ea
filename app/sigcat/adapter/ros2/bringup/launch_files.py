"""Launch files: nodes brought through their transitions, the same in XML, and all nodes in one container."""

from collections.abc import Iterator

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.ros2.bringup.graph import in_order_of_activation
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.adapter.templates import rendered

_TEMPLATES = {
    ".launch.py": "launch.py.j2",
    ".launch.xml": "launch.xml.j2",
    "_container.launch.py": "container_launch.py.j2",
}
"""Templates by what the names of their files end with."""


def launch_files(workspace: WorkspacePlan) -> Iterator[GeneratedFile]:
    """The files, by their names in the package."""
    name = workspace.name
    nodes = in_order_of_activation(workspace)
    for ending, template in _TEMPLATES.items():
        text = rendered(
            f"adapter/ros2/bringup/{template}",
            rights=rights(workspace.package),
            name=name,  # name of the package
            namespace=workspace.namespace.strip("/"),
            has_bond=workspace.has_bond,
            nodes=nodes,  # in the order of activation
        )
        yield GeneratedFile(f"launch/{name}{ending}", text.encode())
