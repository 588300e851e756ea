"""Function files of either kind, as the functions that an integration starts from."""

from collections.abc import Callable
from typing import NamedTuple

from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.model import Catalogue
from app.errors import InputRefused
from app.findings import Finding, has_errors
from app.function.build import build_function, is_function_json
from app.function.model import FunctionJson
from app.function.validate import read_function_json


class ReadFunction(NamedTuple):
    """A function, and the warnings of its file."""

    function: FunctionJson
    findings: tuple[Finding, ...]


def read_function(
    data: bytes, name: str, catalogue: Callable[[], Catalogue], limits: Limits = DEFAULT_LIMITS
) -> ReadFunction:
    """The function of a `function.yaml` or a Function JSON. Only the first needs a catalogue.

    Raises InputRefused with every finding if there are errors.
    """
    if not is_function_json(data, name):
        return ReadFunction(*build_function(data, name, catalogue()))
    function, findings = read_function_json(data, name, limits=limits)
    if function is None or has_errors(findings):
        raise InputRefused(f"{name} cannot be integrated: it has errors.", findings)
    _refuse_version(function, name)
    _refuse_integration(function, name)
    return ReadFunction(function, findings)


def _refuse_version(function: FunctionJson, name: str) -> None:
    """Another major version may mean other things by the same words."""
    version = function.meta.schema_version
    if version is not None and version.split(".")[0] != "1":
        message = f"{name} is of schema version {version}; sigcat reads version 1."
        finding = Finding("F004", "error", message, name, pointer="/MetaInfo/SchemaVersion")
        raise InputRefused(message, (finding,))


def _refuse_integration(function: FunctionJson, name: str) -> None:
    """Integration JSON for ROS 2 is Function JSON with more, and would be taken for a function."""
    if "CommunicationList" in (function.model_extra or {}):
        message = f"{name} is Integration JSON already; functions are integrated from Function JSON or function.yaml."
        raise InputRefused(message, (Finding("F003", "error", message, name, pointer="/CommunicationList"),))
