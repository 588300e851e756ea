"""VSS paths that a deployment gives to signals that are not there, most likely by a typing error: alike on every platform."""

from sigcat.findings import RuleCode
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.walk import parts
from sigcat.integration.application import Application
from sigcat.integration.finding_collector import FindingCollector
from sigcat.names import did_you_mean

SECTION = "paths"


def report_unknown_paths(rule: RuleCode, application: Application, findings: FindingCollector) -> None:
    """A finding for each key of `paths` that is no `Function.Signal` of the set."""
    known = {
        f"{resolved.function.info.function_name}.{part.name}"
        for resolved in application.functions
        for _, part in parts(resolved.function)
        if isinstance(part, Signal | DataQueue)
    }
    for key in application.paths:
        if key not in known:
            message = f"Nothing in the set is called {key!r}, which the deployment file names under `{SECTION}`."
            findings.report_deployment(rule, message, (SECTION, key), did_you_mean(key, known), key)
