"""Findings of `derive`, each at the part of a function that it is about."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from pydantic import BaseModel

from sigcat.findings import Finding, RuleCode
from sigcat.function.document.document import Pointer
from sigcat.function.exchange import Side
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import parts
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.names import did_you_mean


class Subject(NamedTuple):
    """A part of a function that findings may be about."""

    name: str
    """Name of the part in findings; empty if the part itself has no name."""
    part: BaseModel

    def __str__(self) -> str:
        return self.name


Reported = Subject | Side | BaseModel | str
"""Part of a function under its name in findings, side of an element, part with a name; or the name of something else."""


def subject_of(part: Side | BaseModel) -> Subject:
    """Return a part of a function, or what a side of an element uses, as findings call it."""
    if isinstance(part, Side):
        return Subject(part.identity, part.interface)
    return Subject(part.name, part)  # type: ignore[attr-defined]


@dataclass
class FindingCollector:
    """Findings in the order in which they were reported, each once."""

    functions: Sequence[ResolvedFunction] = ()
    deployment: Deployment = NO_DEPLOYMENT
    _found: dict[Finding, None] = field(default_factory=dict)

    def report(self, rule: RuleCode, message: str, subject: Reported = "", fix: str = "", *, key: str = "") -> None:
        """Report one about a part of a function, at its field `key` if one is to blame; or about whatever else is named."""
        self._found[self._finding(rule, message, subject, fix, key)] = None

    def report_deployment(self, rule: RuleCode, message: str, pointer: Pointer, fix: str, path: str) -> None:
        """Report one about a place in the deployment file, which has a setting for `path`."""
        self._found[self.deployment.finding(rule, pointer, message, fix, path)] = None

    def report_unknown(self, rule: RuleCode, section: Pointer, keys: Iterable[str], known: Collection[str]) -> None:
        """Report each key of a section of the deployment file that names nothing of the set, most likely by a typing error."""
        for key in keys:
            if key not in known:
                place = ": ".join(map(str, section))
                message = f"Nothing in the set is called {key!r}, which the deployment file names under `{place}`."
                self.report_deployment(rule, message, (*section, key), did_you_mean(key, known), key)

    def take(self, findings: Iterable[Finding]) -> None:
        """Add findings of other code."""
        self._found.update(dict.fromkeys(findings))

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All of them."""
        return tuple(self._found)

    def _finding(self, rule: RuleCode, message: str, reported: Reported, fix: str, key: str) -> Finding:
        subject = reported if isinstance(reported, Subject | str) else subject_of(reported)
        if isinstance(subject, str) or id(subject.part) not in self._parts:
            return rule.finding(message, path=str(subject), fix=fix)
        function, pointer = self._parts[id(subject.part)]
        return function.finding(rule, (*pointer, key) if key else pointer, message, fix, subject.name)

    @cached_property
    def _parts(self) -> dict[int, tuple[ResolvedFunction, Pointer]]:
        """Every part of the functions by its identity: equal parts of two calls have two places."""
        return {
            id(part): (function, pointer) for function in self.functions for pointer, part in parts(function.function)
        }
