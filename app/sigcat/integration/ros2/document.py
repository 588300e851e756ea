"""Integration JSON for ROS 2 from anywhere: the model, or everything that is wrong with it."""

from pydantic import ValidationError

from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.document.read_json import read_json
from sigcat.function.document.structure import structural_findings
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.limits import DEFAULT_LIMITS, Limits


def read_integration(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Ros2Integration:
    """The model of a document. Raises InputRefused with every finding."""
    document = read_json(data, name, limits)
    findings = document.findings
    if not has_errors(findings):
        try:
            return Ros2Integration.model_validate(document.value, by_name=False)
        except ValidationError as error:
            findings = (*findings, *structural_findings(error, document, Ros2Integration))
    raise InputRefused(f"{name} must be Integration JSON as `sigcat integrate ros2` writes it.", findings)
