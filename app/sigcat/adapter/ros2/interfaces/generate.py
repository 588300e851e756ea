"""The files of an interface package."""

from sigcat.adapter.files import GeneratedFile, within
from sigcat.adapter.ros2.interfaces.message_text import message_text, service_text
from sigcat.adapter.ros2.package_xml import package_xml
from sigcat.adapter.text_filters import cmake_argument
from sigcat.integration.ros2.model import InterfacePackage


def interface_files(package: InterfacePackage) -> tuple[GeneratedFile, ...]:
    """The package, in a folder of its name."""
    messages = {f"msg/{message.name}.msg": message_text(message) for message in package.messages}
    services = {f"srv/{service.name}.srv": service_text(service) for service in package.services}
    texts = {
        "CMakeLists.txt": _cmake(package, [*messages, *services]),
        **messages,
        "package.xml": package_xml(package, package.name, _depends(package), "ament_cmake"),
        **services,
    }
    return within(package.name, (GeneratedFile(name, text.encode()) for name, text in texts.items()))


def _depends(package: InterfacePackage) -> list[tuple[str, str]]:
    return [
        ("buildtool_depend", "ament_cmake"),
        ("buildtool_depend", "rosidl_default_generators"),
        *(("depend", name) for name in package.dependencies),
        ("exec_depend", "rosidl_default_runtime"),
        ("member_of_group", "rosidl_interface_packages"),
    ]


def _cmake(package: InterfacePackage, files: list[str]) -> str:
    found = "".join(f"find_package({name} REQUIRED)\n" for name in package.dependencies)
    listed = "".join(f'  "{cmake_argument(name)}"\n' for name in files)
    others = f"  DEPENDENCIES {' '.join(package.dependencies)}\n" if package.dependencies else ""
    return f"""cmake_minimum_required(VERSION 3.16)
project({package.name})

find_package(ament_cmake REQUIRED)
{found}find_package(rosidl_default_generators REQUIRED)

rosidl_generate_interfaces(${{PROJECT_NAME}}
{listed}{others})

ament_export_dependencies(rosidl_default_runtime)
ament_package()
"""
