"""ROS 2, as the table of platforms has it."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sigcat.integration.ros2.releases import DEFAULT_RELEASE, RELEASES
from sigcat.platforms.platform import Generator, Integrated, Options, Platform

if TYPE_CHECKING:
    from sigcat.adapter.files import GeneratedFile
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.report import Entry
    from sigcat.integration.ros2.settings import Ros2Settings
    from sigcat.limits import Limits


def _settings() -> "type[Ros2Settings]":
    from sigcat.integration.ros2.settings import Ros2Settings

    return Ros2Settings


def _derive(functions: "Sequence[ResolvedFunction]", deployment: "Deployment", settings: "Ros2Settings") -> Integrated:
    from sigcat.function.function_json.wire import written
    from sigcat.integration.ros2.ros2_integration import derive

    model, findings, report = derive(functions, deployment, settings)
    return Integrated(written(model), findings, report)


def _with_files(deployment: "Deployment", folder: "Path", environment: "Mapping[str, str]") -> "Deployment":
    from sigcat.integration.ros2.messages.installed_messages import with_installed_messages

    settings: Ros2Settings = deployment.ros2  # type: ignore[attr-defined]
    return deployment.model_copy(update={"ros2": with_installed_messages(settings, folder, environment)})


def _schema() -> dict[str, Any]:
    from sigcat.function.function_json.wire import document_schema
    from sigcat.integration.ros2.model import Ros2Integration

    return document_schema(Ros2Integration)


def _generate(data: bytes, name: str, limits: "Limits", options: Options) -> "tuple[GeneratedFile, ...]":
    from sigcat.adapter.ros2.ros2_workspace import generate

    return generate(data, name, limits, options.release)


def _report(data: bytes, name: str, limits: "Limits") -> "tuple[Entry, ...]":
    from sigcat.adapter.ros2.report import report

    return report(data, name, limits)


PACKAGES = Generator(
    name="ros2",
    title="ROS 2 packages",
    target="ROS 2",
    contents="messages, lifecycle nodes in C++ and Python, launch file, parameters and tests",
    media_type="text/plain",
    report=_report,
    generate=_generate,
    releases=RELEASES,
    default_release=DEFAULT_RELEASE,
    release_word="distribution",
    view="ros2-packages",
)
ROS2 = Platform("ros2", "ROS 2", _settings, _derive, _schema, (PACKAGES,), with_files=_with_files)
