"""VSS paths that a deployment gives to signals that are not there, most likely by a typing error: alike on every platform."""

from sigcat.findings import RuleCode
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.walk import parts
from sigcat.integration.application import Application
from sigcat.integration.finding_collector import FindingCollector


def report_unknown_paths(rule: RuleCode, application: Application, findings: FindingCollector) -> None:
    """A finding for each key of `paths` that is no `Function.Signal` of the set."""
    known = {
        f"{function.info.function_name}.{part.name}"
        for function in application.wholes
        for _, part in parts(function)
        if isinstance(part, Signal | DataQueue)
    }
    findings.report_unknown(rule, ("paths",), application.paths, known)
