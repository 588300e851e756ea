"""The files of an interface package."""

from collections.abc import Sequence

from sigcat.adapter.files import GeneratedFile, within
from sigcat.adapter.ros2.package_xml import package_xml
from sigcat.adapter.templates import rendered
from sigcat.integration.ros2.model import InterfacePackage, Message, Service

_FOLDER = "adapter/ros2/interfaces"


def interface_files(package: InterfacePackage) -> tuple[GeneratedFile, ...]:
    """The package, in a folder of its name."""
    messages = {f"msg/{message.name}.msg": _message(message) for message in package.messages}
    services = {f"srv/{service.name}.srv": _service(service) for service in package.services}
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
        *(("test_depend", name) for name in ("ament_lint_auto", "ament_lint_common")),
        ("member_of_group", "rosidl_interface_packages"),
    ]


def _message(message: Message) -> str:
    return rendered(
        f"{_FOLDER}/message.msg.j2", description=message.description, constants=message.constants, fields=message.fields
    )


def _service(service: Service) -> str:
    return rendered(
        f"{_FOLDER}/service.srv.j2", description=service.description, request=service.request, response=service.response
    )


def _cmake(package: InterfacePackage, files: Sequence[str]) -> str:
    return rendered(f"{_FOLDER}/CMakeLists.txt.j2", name=package.name, dependencies=package.dependencies, files=files)
