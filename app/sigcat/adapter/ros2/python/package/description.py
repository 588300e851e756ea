"""Files of the package beside its modules: what ament_python, linters and `colcon test` read."""

from sigcat.adapter.ros2.package_xml import package_xml
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.names import snake_case

_DEPENDENCIES = (
    "ament_index_python", "builtin_interfaces", "diagnostic_msgs", "python3-cffi", "rcl_interfaces", "rclpy",
)  # fmt: skip
_TEST_DEPENDENCIES = ("ament_flake8", "ament_pep257", "domain_coordinator", "lifecycle_msgs", "python3-pytest")


def package_name(workspace: WorkspacePlan) -> str:
    """Name of the package: `eco_control_py`."""
    return f"{workspace.name}_py"


def core_stem(node: NodePlan) -> str:
    """Module of a core: `core_acc_core`."""
    return f"{snake_case(node.core.function)}_core"


def package_description(workspace: WorkspacePlan) -> str:
    """package.xml."""
    bond = {"bondpy"} if workspace.has_bond and workspace.release != "humble" else set()
    others = {workspace.name, workspace.interfaces, *workspace.message_packages}
    needed = [("exec_depend", name) for name in sorted({*_DEPENDENCIES, *bond, *others})]
    tested = [("test_depend", name) for name in _TEST_DEPENDENCIES]
    return package_xml(workspace.package, package_name(workspace), [*needed, *tested], "ament_python")


def setup_py(workspace: WorkspacePlan) -> str:
    """setup.py, with an executable for each node."""
    return _described("setup.py", workspace)


def setup_cfg(workspace: WorkspacePlan) -> str:
    """setup.cfg: executables stand where `ros2 run` looks for them."""
    return _described("setup.cfg", workspace)


def init_module(workspace: WorkspacePlan) -> str:
    """Description of the package."""
    return _described("__init__.py", workspace)


def _described(name: str, workspace: WorkspacePlan) -> str:
    return rendered(
        f"adapter/ros2/python/package/{name}.j2",
        name=package_name(workspace),
        package=workspace.package,
        application=workspace.application,
        nodes=workspace.nodes,
    )
