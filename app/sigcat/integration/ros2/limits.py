"""What ROS 2 cannot express, and what had to be assumed: a finding for each, which names the interface."""

from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding, RuleCode


class Limits:
    """Findings, gathered while a model is derived: each once."""

    def __init__(self) -> None:
        self._found: dict[Finding, None] = {}

    def report(self, rule: RuleCode, interface: str, message: str, fix: str = "") -> None:
        """Note one."""
        self._found[rule.finding(message, path=interface, fix=fix)] = None

    def renamed(self, interface: str, source: str, name: str, reason: str) -> None:
        """Note that a name was changed, if there is a reason."""
        if reason:
            self.report(codes.NAME_CHANGED, interface, f"{source!r} is called {name!r} in ROS 2: {reason}.")

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All of them, in the order in which they were met."""
        return tuple(self._found)


class Renamed(NamedTuple):
    """A datatype of a function that has another name in the set."""

    function: str
    old: str
    new: str
