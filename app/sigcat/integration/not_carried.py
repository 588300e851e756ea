"""Findings about fields that have no place in the Integration JSON of a platform of AUTOSAR."""

from collections.abc import Sequence

from pydantic import BaseModel

from sigcat.findings import RuleCode
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import parts
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.report import NOT_CARRIED, Entry


def report_not_carried(
    rule: RuleCode, targets: Sequence[Entry], functions: Sequence[ResolvedFunction], findings: FindingCollector
) -> None:
    """A finding of the platform's rule for each field that no target is known for."""
    for entry in targets:
        if entry.target == NOT_CARRIED:
            message = f"{entry.field} of {entry.interface} ({entry.function}) has no place in the Integration JSON: {entry.note}."
            holder = _holder(entry, functions)
            subject = entry.interface if holder is None else Subject(entry.interface, holder)
            findings.report(rule, message, subject, key=entry.field)


def _holder(entry: Entry, functions: Sequence[ResolvedFunction]) -> BaseModel | None:
    """The part of a function that has the field of an entry."""
    function = next(each.function for each in functions if each.name == entry.function)
    named = (part for _, part in parts(function) if getattr(part, "name", entry.function) == entry.interface)
    return next((part for part in named if entry.field in (part.model_extra or ())), None)
