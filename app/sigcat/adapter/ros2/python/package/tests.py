"""Tests of the package, which `colcon test` runs: linters, cores without ROS, nodes in lock-step."""

from collections.abc import Sequence

from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.ros2.python.core.module import core_type
from sigcat.adapter.ros2.python.names import Import, imports
from sigcat.adapter.ros2.python.package.description import core_stem, package_name
from sigcat.adapter.templates import rendered

COMMON = ("conftest.py", "test_flake8.py", "test_pep257.py")
"""Files of tests that are the same in every package."""


def common(name: str) -> str:
    """The file of that name."""
    return rendered(f"adapter/ros2/python/package/{name}.j2")


def core_test(node: NodePlan, workspace: WorkspacePlan) -> str:
    """Tests of a core, which need no ROS but its packages."""
    core, name = core_type(node.core), package_name(workspace)
    modules = [(f"{name}.{core_stem(node)}", [core]), (f"{name}.support.core", ["LayoutError"]), ("pytest", ())]
    return _test("test_core.py", node, imports(modules))


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
    return _test("test_node.py", node, imports(modules))


def _test(name: str, node: NodePlan, needed: Sequence[Import]) -> str:
    return rendered(
        f"adapter/ros2/python/package/{name}.j2",
        function=node.core.function,
        imports=needed,
        core=core_type(node.core),
        type=node.type,
        is_stored=node.core.is_stored,
    )
