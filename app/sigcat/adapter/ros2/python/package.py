"""Files of the package beside its modules: what ament_python, linters and `colcon test` read."""

from sigcat.adapter.core.c.lines import Lines, lines
from sigcat.adapter.ros2.package_xml import package_xml
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.ros2.python.names import docstring
from sigcat.function.document.text_filters import python_string
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


def description(workspace: WorkspacePlan) -> str:
    """package.xml."""
    needed = [
        ("exec_depend", name)
        for name in sorted({*_DEPENDENCIES, workspace.name, workspace.interfaces, *workspace.message_packages})
    ]
    tested = [("test_depend", name) for name in _TEST_DEPENDENCIES]
    return package_xml(workspace.package, package_name(workspace), [*needed, *tested], "ament_python")


def setup_py(workspace: WorkspacePlan) -> Lines:
    """setup.py, with an executable for each node."""
    name = package_name(workspace)
    scripts = "".join(
        f"            {python_string(f'{node.executable} = {name}.{node.stem}:main')},\n" for node in workspace.nodes
    )
    return lines(f"""
from setuptools import find_packages, setup

package_name = {python_string(name)}

setup(
    name=package_name,
    version={python_string(workspace.package.version)},
    packages=find_packages(exclude=['test']),
    package_data={{package_name: ['py.typed']}},
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools', 'cffi'],
    zip_safe=False,
    maintainer={python_string(workspace.package.maintainer)},
    maintainer_email={python_string(workspace.package.email)},
    description={python_string(f"{workspace.application} in Python.")},
    license={python_string(workspace.package.license)},
    tests_require=['pytest'],
    entry_points={{
        'console_scripts': [
{scripts}        ],
    }},
)
""")


def setup_cfg(workspace: WorkspacePlan) -> str:
    """setup.cfg: executables stand where `ros2 run` looks for them."""
    name = package_name(workspace)
    return f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n"


def init_module(workspace: WorkspacePlan) -> Lines:
    """What the package is."""
    functions = ", ".join(node.core.function for node in workspace.nodes)
    return docstring(f"Nodes and cores of {functions}, in Python.")
