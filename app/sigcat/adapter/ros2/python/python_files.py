"""From the plan of a workspace to the package in Python, and the bridges that its cores are compiled with."""

from collections.abc import Iterable
from pathlib import Path

from sigcat.adapter.files import GeneratedFile, shipped, within
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.ros2.python.core.bridge import bridge_files
from sigcat.adapter.ros2.python.core.module import core_module
from sigcat.adapter.ros2.python.names import written
from sigcat.adapter.ros2.python.node.module import node_module
from sigcat.adapter.ros2.python.package import tests
from sigcat.adapter.ros2.python.package.description import core_stem, described, package_description, package_name

SUPPORT = Path(__file__).parent / "support"
"""Modules that are the same in every package."""
SUPPORT_OF_HUMBLE = Path(__file__).parent / "support_of_humble"
"""Replacements of some of them for Humble."""
_EVENTS = {"jazzy": b"rclpy.event_handler", "humble": b"rclpy.qos_event"}
"""The module of rclpy that has the events of the quality of service."""


def python_files(workspace: WorkspacePlan) -> tuple[GeneratedFile, ...]:
    """The files, by their names in the workspace."""
    bridges = (file for node in workspace.nodes for file in bridge_files(node.core))
    return (
        *within(f"{workspace.name}/core", bridges),
        *within(package_name(workspace), _package(workspace)),
    )


def _package(workspace: WorkspacePlan) -> Iterable[GeneratedFile]:
    name = package_name(workspace)
    yield _text("package.xml", package_description(workspace))
    yield _module("setup.py", described("setup.py", workspace))
    yield _text("setup.cfg", described("setup.cfg", workspace))
    yield _text(f"resource/{name}", "")
    yield _module(f"{name}/__init__.py", described("__init__.py", workspace))
    yield _text(f"{name}/py.typed", "")
    yield from within(f"{name}/support", _support(workspace))
    for node in workspace.nodes:
        yield from _node(node, workspace)
    yield from (_text(f"test/{name}", tests.common(name)) for name in tests.COMMON)


def _support(workspace: WorkspacePlan) -> Iterable[GeneratedFile]:
    files = {file.name: file for file in shipped(SUPPORT) if workspace.has_bond or file.name != "bond.py"}
    if workspace.release == "humble":
        files |= {file.name: file for file in shipped(SUPPORT_OF_HUMBLE) if file.name != "__init__.py"}
    events = _EVENTS[workspace.release]
    return (file._replace(data=file.data.replace(_EVENTS["jazzy"], events)) for file in files.values())


def _node(node: NodePlan, workspace: WorkspacePlan) -> Iterable[GeneratedFile]:
    name = package_name(workspace)
    core, stem = core_stem(node), node.stem
    yield _module(f"{name}/{core}.py", core_module(node))
    yield _module(f"{name}/{stem}.py", node_module(node, has_bond=workspace.has_bond))
    yield _module(f"test/test_{core}.py", tests.core_test(node, workspace))
    yield _module(f"test/test_{stem}.py", tests.node_test(node, workspace))


def _module(name: str, text: str) -> GeneratedFile:
    return GeneratedFile(name, written(text))


def _text(name: str, text: str) -> GeneratedFile:
    return GeneratedFile(name, text.encode())
