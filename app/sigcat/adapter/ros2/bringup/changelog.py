"""CHANGELOG.rst, as catkin tools and bloom read it: the version that the package has now, and what it is made of."""

from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.integration.ros2.model import Ros2Integration


def changelog(package: str, version: str, workspace: WorkspacePlan, model: Ros2Integration) -> str:
    """The text of a package's file. A document without a date is not released yet."""
    day = "-".join(reversed((model.meta.date or "").split(".")))
    functions = [" ".join(filter(None, (node.core.function, node.core.version))) for node in workspace.nodes]
    return rendered(
        "adapter/ros2/bringup/CHANGELOG.rst.j2",
        package=package,
        version=f"{version} ({day})" if day else "Forthcoming",
        functions=functions,  # each with its version, if it has one
    )
