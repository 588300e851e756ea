"""Launch file, parameter files and README of a workspace."""

from collections.abc import Iterator

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.ros2.bringup.launch_file import launch_file
from sigcat.adapter.ros2.bringup.parameter_file import parameter_file
from sigcat.adapter.ros2.bringup.readme import readme
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.integration.ros2.model import Ros2Integration


def bringup_files(workspace: WorkspacePlan, model: Ros2Integration) -> Iterator[GeneratedFile]:
    """The files, by their names in the workspace."""
    name = workspace.name
    yield GeneratedFile("README.md", readme(workspace, model).encode())
    yield GeneratedFile(f"{name}/launch/{name}.launch.py", launch_file(workspace).encode())
    for node in workspace.nodes:
        yield GeneratedFile(f"{name}/config/{node.name}.yaml", parameter_file(node, workspace).encode())
