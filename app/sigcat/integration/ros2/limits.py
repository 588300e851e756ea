"""What ROS 2 cannot express, and what had to be assumed: a finding for each, which names the interface."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.findings import Finding, Severity

SEVERITIES: Mapping[str, Severity] = {
    "N200": "error",  # a datatype that nothing defines, or that no message can have
    "N201": "warning",  # an ASIL
    "N202": "info",  # a stack size
    "N203": "warning",  # a priority that is no priority of a thread
    "N204": "warning",  # an order between nodes
    "N205": "warning",  # a logical supervision in words
    "N206": "info",  # a reset condition in words
    "N207": "warning",  # ignition cycles
    "N208": "warning",  # values kept over a restart
    "N209": "warning",  # a parameter of a kind that nodes do not have
    "N210": "info",  # a name that had to be changed
    "N211": "warning",  # a signal without a path
    "N212": "info",  # a signal without a variable
    "N213": "warning",  # a time-out that is too short for the provider's cycle
    "N214": "error",  # two functions that mean one signal in two ways
    "N215": "error",  # a call that nothing triggers
    "N216": "info",  # an error from outside of the set
    "N217": "error",  # a factor or an offset that is no number
    "N218": "warning",  # several publishers of one signal
}


class Limits:
    """Findings, gathered while a model is derived: each once."""

    def __init__(self) -> None:
        self._found: dict[Finding, None] = {}

    def report(self, rule: str, interface: str, message: str, fix: str = "") -> None:
        """Note one. The severity is the rule's."""
        self._found[Finding(rule, SEVERITIES[rule], message, path=interface, fix=fix)] = None

    def renamed(self, interface: str, source: str, name: str, reason: str) -> None:
        """Note that a name was changed, if there is a reason."""
        if reason:
            self.report("N210", interface, f"{source!r} is called {name!r} in ROS 2: {reason}.")

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All of them, in the order in which they were met."""
        return tuple(self._found)


class Renamed(NamedTuple):
    """A datatype of a function that has another name in the set."""

    function: str
    old: str
    new: str
