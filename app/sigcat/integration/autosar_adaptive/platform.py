"""AUTOSAR adaptive, as the table of platforms has it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from sigcat.integration.platform import Integrated, Platform

if TYPE_CHECKING:
    from sigcat.function.function_json.model import FunctionJson
    from sigcat.integration.autosar_adaptive.settings import AutosarAdaptiveSettings
    from sigcat.integration.deployment import Deployment


def _settings() -> "type[AutosarAdaptiveSettings]":
    from sigcat.integration.autosar_adaptive.settings import AutosarAdaptiveSettings

    return AutosarAdaptiveSettings


def _derive(
    functions: "Sequence[FunctionJson]", deployment: "Deployment", settings: "AutosarAdaptiveSettings"
) -> Integrated:
    from sigcat.integration.autosar_adaptive.derive import derive
    from sigcat.integration.autosar_adaptive.model import to_json

    model, findings, report = derive(functions, deployment, settings)
    return Integrated(to_json(model), findings, report)


def _schema() -> dict[str, Any]:
    from sigcat.integration.autosar_adaptive.model import integration_schema

    return integration_schema()


AUTOSAR_ADAPTIVE = Platform("autosar-adaptive", "AUTOSAR adaptive", _settings, _derive, _schema)
