"""ROS 2, as the table of platforms has it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sigcat.platforms.platform import Integrated, Platform

if TYPE_CHECKING:
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.integration.deployment import Deployment
    from sigcat.integration.ros2.settings import Ros2Settings


def _settings() -> "type[Ros2Settings]":
    from sigcat.integration.ros2.settings import Ros2Settings

    return Ros2Settings


def _derive(functions: "Sequence[ResolvedFunction]", deployment: "Deployment", settings: "Ros2Settings") -> Integrated:
    from sigcat.integration.ros2.derive import derive
    from sigcat.integration.ros2.model import to_json

    model, findings, report = derive(functions, deployment, settings)
    return Integrated(to_json(model), findings, report)


def _schema() -> dict[str, Any]:
    from sigcat.integration.ros2.model import integration_schema

    return integration_schema()


ROS2 = Platform("ros2", "ROS 2", _settings, _derive, _schema)
