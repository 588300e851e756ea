"""The files of the package of nodes in C++."""

from collections.abc import Iterator
from pathlib import Path

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.long_lines import ROS, fitted
from sigcat.adapter.ros2.cpp.cmake import cmake
from sigcat.adapter.ros2.cpp.node.header import node_header
from sigcat.adapter.ros2.cpp.node.source import main_source, node_source
from sigcat.adapter.ros2.cpp.structs import structs_header
from sigcat.adapter.ros2.cpp.tests import launch_test, node_test
from sigcat.adapter.ros2.package_xml import package_xml, rights
from sigcat.adapter.ros2.plan import WorkspacePlan
from sigcat.adapter.templates import rendered

_DEPENDS = (
    "builtin_interfaces",
    "diagnostic_msgs",
    "rcl_interfaces",
    "rclcpp",
    "rclcpp_components",
    "rclcpp_lifecycle",
)
_TEST_DEPENDS = (
    "ament_cmake_gtest", "ament_cmake_ros", "ament_lint_auto", "ament_lint_common", "launch_testing_ament_cmake",
    "launch_testing_ros", "lifecycle_msgs",
)  # fmt: skip
_FOLDER = "adapter/ros2/cpp/support"
SUPPORT = Path(__file__).parent / "support"
"""Templates of files that all nodes have in common."""


def cpp_files(workspace: WorkspacePlan) -> Iterator[GeneratedFile]:
    """All files but the cores and their bridges to Python, by their names in the package."""
    support = tuple(_support(workspace))
    sources = [Path(file.name).name for file in support if file.name.startswith("src/")]
    own = {
        "CMakeLists.txt": cmake(workspace, sources),
        "package.xml": package_xml(workspace.package, workspace.name, _dependencies(workspace), "ament_cmake"),
    }
    own["test/test_launch.py"] = launch_test(workspace)
    for node in workspace.nodes:
        own[f"test/test_{node.stem}.cpp"] = fitted(node_test(node, workspace), ROS)
        own[f"include/{workspace.name}/{node.stem}.hpp"] = fitted(node_header(node, workspace), ROS)
        own[f"src/{node.stem}.cpp"] = fitted(node_source(node, workspace), ROS)
        own[f"src/{node.name}_main.cpp"] = fitted(main_source(node, workspace), ROS)
        if node.structs:
            own[f"include/{workspace.name}/{node.name}_structs.hpp"] = fitted(structs_header(node, workspace), ROS)
    made = (GeneratedFile(name, text.encode()) for name, text in own.items())
    yield from (*made, *support)


def _support(workspace: WorkspacePlan) -> Iterator[GeneratedFile]:
    """Yield support files that a node of the set uses."""
    unused = {
        *(() if any(node.priority is not None for node in workspace.nodes) else ("scheduling",)),
        *(() if any(node.core.has_deadline for node in workspace.nodes) else ("watch",)),
        *(() if any(node.core.is_stored for node in workspace.nodes) else ("storage", "stored_text")),
        *(() if workspace.has_bond else ("bond",)),
    }
    for path in sorted(SUPPORT.rglob("*.j2")):
        name = path.name.removesuffix(".j2")
        if Path(name).stem.removeprefix("test_") in unused:
            continue
        folder = f"include/{workspace.name}" if name.endswith(".hpp") else path.parent.name
        text = rendered(
            f"{_FOLDER}/{path.parent.name}/{path.name}",
            rights=rights(workspace.package),
            package=workspace.name,
            guard=workspace.name.upper(),  # include guards begin with it
        )
        yield GeneratedFile(f"{folder}/{name}", text.encode())


def _dependencies(workspace: WorkspacePlan) -> Iterator[tuple[str, str]]:
    yield "buildtool_depend", "ament_cmake"
    bond, index = (("bondcpp",), ("ament_index_python",)) if workspace.has_bond else ((), ())
    needed = {*_DEPENDS, *bond, workspace.interfaces, *workspace.message_packages}
    yield from (("depend", name) for name in sorted(needed))
    yield from (("exec_depend", name) for name in (*index, "launch", "launch_ros", "lifecycle_msgs"))
    yield from (("test_depend", name) for name in _TEST_DEPENDS)
