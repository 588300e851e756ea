"""Common input of every step of `derive` for AUTOSAR: the functions with their components, the settings, the findings."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from sigcat.findings import RuleCode
from sigcat.function.exchange import Exchange, Part, exchange_of
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.application import DEFAULT_VERSION, Application, application
from sigcat.integration.autosar_parts import named_parts
from sigcat.integration.deployment import Deployment
from sigcat.integration.finding_collector import FindingCollector

S = TypeVar("S")
T = TypeVar("T")
NO_DATE = "1970-01-01"
"""Date of a document whose functions have none: it has to have one, and today's would change the bytes."""


@dataclass(frozen=True)
class AutosarContext(Generic[S, T]):
    """Input of one derivation, and the findings on its way."""

    application: Application
    settings: S
    parts: tuple[Part, ...]
    exchange: Exchange
    types: T
    """Datatypes of the set, so far as they were referred to."""
    findings: FindingCollector


def autosar_context(
    functions: Sequence[ResolvedFunction],
    deployment: Deployment,
    settings: S,
    types_of: Callable[[FindingCollector], T],
) -> AutosarContext[S, T]:
    """The context of a derivation: components under their names, and what they exchange."""
    app = application(functions, deployment)
    parts = named_parts(app.wholes)
    findings = FindingCollector(app.functions, deployment)
    return AutosarContext(app, settings, parts, exchange_of(parts, app.paths), types_of(findings), findings)


def application_information(app: Application) -> dict[str, Any]:
    """Fields of a document about the identity of the application."""
    return {
        "name": app.name,
        "responsible": app.responsible,
        "description": app.description,
        "functions": tuple(function.name for function in app.functions),
    }


def meta_information(date_missing: RuleCode, context: AutosarContext[Any, Any]) -> dict[str, Any]:
    """Fields of a document about who is responsible for it; a missing date is reported."""
    app = context.application
    if app.date is None:
        message = f"No function has a date: the document has {NO_DATE}."
        context.findings.report(date_missing, message, fix="Set `date` in the deployment file or in a function.")
    return {
        "authority": app.authority,
        "author": app.author,
        "date": app.date.isoformat() if app.date else NO_DATE,
        "version": app.version or DEFAULT_VERSION,
    }
