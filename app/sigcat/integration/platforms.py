"""The platforms that functions are integrated with, behind one call."""

from collections.abc import Sequence
from typing import Literal, NamedTuple, get_args

from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.deployment import Deployment
from sigcat.integration.report import Entry

Platform = Literal["autosar-adaptive", "ros2"]
PLATFORMS: tuple[Platform, ...] = get_args(Platform)


class Integrated(NamedTuple):
    """An Integration JSON, what is to be said about it, and where each field of each interface went."""

    document: bytes
    findings: tuple[Finding, ...]
    report: tuple[Entry, ...]


@collector_paused()
def integrate(platform: Platform, functions: Sequence[FunctionJson], deployment: Deployment) -> Integrated:
    """Derive the Integration JSON for a platform. Raises InputRefused if a field of an interface has no place in it."""
    made = _ros2(functions, deployment) if platform == "ros2" else _autosar_adaptive(functions, deployment)
    if has_errors(made.findings):
        raise InputRefused("The functions cannot be integrated as they are.", made.findings)
    return made


def _ros2(functions: Sequence[FunctionJson], deployment: Deployment) -> Integrated:
    from sigcat.integration.ros2.derive import derive
    from sigcat.integration.ros2.model import to_json

    model, findings, report = derive(functions, deployment)
    return Integrated(to_json(model), findings, report)


def _autosar_adaptive(functions: Sequence[FunctionJson], deployment: Deployment) -> Integrated:
    from sigcat.integration.autosar_adaptive.derive import derive
    from sigcat.integration.autosar_adaptive.model import to_json

    model, findings, report = derive(functions, deployment)
    return Integrated(to_json(model), findings, report)
