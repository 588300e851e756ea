"""What `derive` has before it: the functions of the set with their components, and a place for what is to be said."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.findings import Finding, RuleCode
from sigcat.function.function_json.model import (
    Component,
    DataQueue,
    Error,
    FunctionJson,
    Method,
    ModeInterface,
    SafetyReaction,
    Signal,
)
from sigcat.function.function_json.model import Runnable as Call
from sigcat.integration.autosar_names import distinct, short_name
from sigcat.integration.deployment import Deployment

Interface = Signal | DataQueue | Method | Error | SafetyReaction | ModeInterface


class Part(NamedTuple):
    """A component of a function, under the name that it has in the set."""

    name: str
    function: FunctionJson
    component: Component

    @property
    def function_name(self) -> str:
        """Name of the function."""
        return self.function.info.function_name


class Item(NamedTuple):
    """An interface of a function at the call that has it; a mode interface belongs to no call."""

    part: Part
    call: Call | None
    interface: Interface

    @property
    def where(self) -> str:
        """For findings: `CoreAcc, CoreAcc_Step`."""
        return self.part.function_name + (f", {self.call.name}" if self.call else "")


class Work:
    """Inputs of one derivation, and its findings."""

    def __init__(self, functions: Sequence[FunctionJson], deployment: Deployment) -> None:
        self.deployment = deployment
        self.findings: list[Finding] = []
        self.parts = _parts(functions)

    def report(self, rule: RuleCode, message: str, path: str = "", fix: str = "") -> None:
        """Note a finding about an interface."""
        self.findings.append(rule.finding(message, path=path, fix=fix))

    def path_of(self, item: Item) -> str:
        """VSS path of a data interface, its own or the one that the deployment tells; empty if there is none."""
        interface = item.interface
        assert isinstance(interface, Signal | DataQueue)
        return interface.vss_path or self.deployment.paths.get(f"{item.part.function_name}.{interface.name}", "")


def _parts(functions: Sequence[FunctionJson]) -> tuple[Part, ...]:
    pairs = [(function, component) for function in functions for component in function.components]
    names = [short_name(component.name) for _, component in pairs]
    lowered = [name.lower() for name in names]
    wanted = {
        f"{index:06d}": name
        if lowered.count(name.lower()) == 1
        else short_name(f"{function.info.function_name}_{component.name}")
        for index, ((function, component), name) in enumerate(zip(pairs, names, strict=True))
    }
    given = distinct(wanted)
    return tuple(Part(given[f"{index:06d}"], function, component) for index, (function, component) in enumerate(pairs))


def items(parts: Sequence[Part]) -> Iterator[Item]:
    """Every interface of every call, in the order of the documents, and the mode interfaces of each function.

    Parameters are not among them: they stay inside their component.
    """
    for part in parts:
        for call in part.component.runnables:
            for contract in call.contracts or ():
                for listed in (
                    contract.signals, contract.queues, contract.methods, contract.errors, contract.safety_reactions
                ):  # fmt: skip
                    yield from (Item(part, call, interface) for interface in listed or ())
        if part.component is part.function.components[0]:
            yield from (Item(part, None, interface) for interface in part.function.mode_interfaces or ())
