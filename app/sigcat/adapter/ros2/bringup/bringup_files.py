"""Launch file, parameter files and README of a workspace."""

from collections.abc import Iterator

from sigcat.adapter.files import GeneratedFile, within
from sigcat.adapter.ros2.bringup.changelog import changelog
from sigcat.adapter.ros2.bringup.launch_files import launch_files
from sigcat.adapter.ros2.bringup.parameter_file import parameter_file, schema_name
from sigcat.adapter.ros2.bringup.parameter_schema import parameter_schema
from sigcat.adapter.ros2.bringup.readme import readme
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.integration.ros2.model import Ros2Integration


def bringup_files(workspace: WorkspacePlan, model: Ros2Integration) -> Iterator[GeneratedFile]:
    """The files, by their names in the workspace."""
    name = workspace.name
    yield GeneratedFile("README.md", readme(workspace, model).encode())
    for package, version in _packages(workspace, model):
        yield GeneratedFile(f"{package}/CHANGELOG.rst", changelog(package, version, workspace, model).encode())
    yield from within(name, launch_files(workspace))
    for node in workspace.nodes:
        yield GeneratedFile(f"{name}/config/{node.name}.yaml", parameter_file(node, workspace).encode())
        yield GeneratedFile(f"{name}/config/{schema_name(node)}", parameter_schema(node).encode())


def _packages(workspace: WorkspacePlan, model: Ros2Integration) -> Iterator[tuple[str, str]]:
    """Every package of the workspace, with its version."""
    yield from ((each.name, each.version) for each in model.interface_packages or ())
    yield workspace.name, workspace.package.version
    yield f"{workspace.name}_py", workspace.package.version
