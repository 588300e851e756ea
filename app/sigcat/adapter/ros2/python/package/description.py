"""Files of the package beside its modules: what ament_python, linters and `colcon test` read."""

from sigcat.adapter.ros2.package_xml import package_xml
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered

_DEPENDENCIES = (
    "ament_index_python", "builtin_interfaces", "diagnostic_msgs", "python3-cffi", "rcl_interfaces", "rclpy",
)  # fmt: skip
_TEST_DEPENDENCIES = ("ament_flake8", "ament_pep257", "domain_coordinator", "lifecycle_msgs", "python3-pytest")


def package_name(workspace: WorkspacePlan) -> str:
    """Name of the package: `eco_control_py`."""
    return f"{workspace.name}_py"


def core_stem(node: NodePlan) -> str:
    """Module of a core: `core_acc_core`."""
    return f"{node.function_stem}_core"


def package_description(workspace: WorkspacePlan) -> str:
    """package.xml."""
    bond = {"bondpy"} if workspace.has_bond and workspace.release != "humble" else set()
    others = {workspace.name, workspace.interfaces, *workspace.message_packages}
    needed = [("exec_depend", name) for name in sorted({*_DEPENDENCIES, *bond, *others})]
    tested = [("test_depend", name) for name in _TEST_DEPENDENCIES]
    return package_xml(workspace.package, package_name(workspace), [*needed, *tested], "ament_python")


def described(name: str, workspace: WorkspacePlan) -> str:
    """A file with this name: setup.py, with an executable for each node; setup.cfg; or the description of the package.

    setup.cfg has executables where `ros2 run` looks for them.
    """
    return rendered(
        f"adapter/ros2/python/package/{name}.j2",
        name=package_name(workspace),
        package=workspace.package,
        application=workspace.application,
        nodes=workspace.nodes,
    )
