"""Tests of the package, which `colcon test` runs: linters, cores without ROS, nodes in lock-step."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.ros2.python.core.module import core_type
from sigcat.adapter.ros2.python.names import Import, imports
from sigcat.adapter.ros2.python.package.description import core_stem, package_name
from sigcat.adapter.templates import rendered

COMMON = ("conftest.py", "test_flake8.py", "test_pep257.py")
"""Files of tests that are the same in every package."""


class _Nothing(NamedTuple):
    """Plan of such a file."""


class _Tests(NamedTuple):
    """Plan of the tests of a core, and of those of its node."""

    function: str
    imports: Sequence[Import]
    core: str
    type: str
    is_stored: bool


def common(name: str) -> str:
    """The file of that name."""
    return rendered(f"adapter/ros2/python/package/{name}.j2", _Nothing())


def core_test(node: NodePlan, workspace: WorkspacePlan) -> str:
    """Tests of a core, which need no ROS but its packages."""
    core, name = core_type(node.core), package_name(workspace)
    modules = [(f"{name}.{core_stem(node)}", [core]), (f"{name}.support.core", ["LayoutError"]), ("pytest", ())]
    return rendered("adapter/ros2/python/package/test_core.py.j2", _tests(node, imports(modules)))


def node_test(node: NodePlan, workspace: WorkspacePlan) -> str:
    """Tests of a node with rclpy: its life, in lock-step."""
    modules = [
        (f"{package_name(workspace)}.{node.stem}", [node.type]),
        ("lifecycle_msgs.srv", ["ChangeState"]),
        (f"{node.step_service.package}.srv", [node.step_service.name]),
        ("pytest", ()),
        ("rclpy", ()),
        ("rclpy.executors", ["SingleThreadedExecutor"]),
        ("rclpy.lifecycle", ["TransitionCallbackReturn"]),
        ("rclpy.parameter", ["Parameter"]),
    ]
    return rendered("adapter/ros2/python/package/test_node.py.j2", _tests(node, imports(modules)))


def _tests(node: NodePlan, needed: Sequence[Import]) -> _Tests:
    return _Tests(node.core.function, needed, core_type(node.core), node.type, node.is_stored)
