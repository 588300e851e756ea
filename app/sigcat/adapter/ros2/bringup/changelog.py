"""CHANGELOG.rst, as catkin tools and bloom read it: the version that the package has now, and what it is made of."""

from collections.abc import Iterator

from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.function.document.text_filters import comment
from sigcat.integration.ros2.model import Ros2Integration


def changelog(package: str, version: str, workspace: WorkspacePlan, model: Ros2Integration) -> str:
    """The text of a package's file. A document without a date is not released yet."""
    title = f"Changelog for package {package}"
    day = ".".join(reversed((model.meta.date or "").split("."))).replace(".", "-")
    head = f"{version} ({day})" if day else "Forthcoming"
    return "\n".join(
        [_line(title, "^"), title, _line(title, "^"), "", head, _line(head, "-"), *_made_of(workspace), ""]
    )


def _line(text: str, sign: str) -> str:
    return sign * len(text)


def _made_of(workspace: WorkspacePlan) -> Iterator[str]:
    for node in workspace.nodes:
        version = f" {node.core.version}" if node.core.version else ""
        yield f"* Generated from the function ``{comment(f'{node.core.function}{version}')}``."
