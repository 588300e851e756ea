"""Errors, safety reactions and modes."""

from collections.abc import Iterable, Mapping
from graphlib import CycleError, TopologicalSorter

from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.runnable import Runnable
from tests.adapter.reference.parts.errors import Error
from tests.adapter.reference.parts.modes import ModeIn, ModeOut
from tests.adapter.reference.parts.reactions import Reaction
from tests.adapter.reference.parts.time_out import TimeOut
from tests.adapter.reference.reading.times import nanoseconds
from tests.adapter.reference.reading.transfers import Table


def _symbols(reference: str, table: Table) -> dict[str, int]:
    datatype = table.get(reference)
    return {each.symbol: each.value for each in (datatype.symbols if datatype else None) or ()}


# -- errors -------------------------------------------------------------------------------------------------------


def errors_of(runnables: Iterable[Runnable], table: Table) -> tuple[Error, ...]:
    """The errors, each after those that it depends on."""
    found: dict[str, Error] = {}
    for runnable in runnables:
        for contract in runnable.contracts or ():
            for item in contract.errors or ():
                found.setdefault(item.name, _error(item, table))
    return tuple(found[name] for name in _in_order(found))


def _error(item: ErrorInterface, table: Table) -> Error:
    numbers = _symbols(item.datatype, table)
    return Error(
        item.name,
        maturation=nanoseconds(item.maturation_time) or 0,
        reset=nanoseconds(item.reset_time) or 0,
        waits_for_restart=item.reset == "Restart",
        reset_input=item.reset,
        dependencies=tuple(name for name in item.dependencies if name != item.name),
        occurrence_limit=item.occurrence_count_limit,
        ignition_limit=item.ignition_count_limit,
        variable=item.variable,
        status_variable=item.status_variable,
        passed=numbers.get("PASSED", 0),
        failed=numbers.get("FAILED", 1),
    )


def _in_order(errors: Mapping[str, Error]) -> tuple[str, ...]:
    graph = {name: [other for other in error.dependencies if other in errors] for name, error in errors.items()}
    try:
        return tuple(TopologicalSorter(graph).static_order())
    except CycleError:
        return tuple(errors)


# -- safety reactions ---------------------------------------------------------------------------------------------


def reactions_of(runnables: Iterable[Runnable], table: Table) -> tuple[Reaction, ...]:
    """The safety reactions, each once, with the calls that list it."""
    found: dict[str, tuple[SafetyReaction, list[str]]] = {}
    for runnable in runnables:
        for contract in runnable.contracts or ():
            for item in contract.safety_reactions or ():
                found.setdefault(item.name, (item, []))[1].append(runnable.name)
    return tuple(_reaction(item, calls, table) for item, calls in found.values())


def _reaction(item: SafetyReaction, calls: Iterable[str], table: Table) -> Reaction:
    numbers = _symbols(item.datatype, table)
    longest = nanoseconds(item.timeout)
    return Reaction(
        item.name,
        item.errors,
        numbers.get("INACTIVE", 0),
        numbers.get("ACTIVE", 1),
        item.initial == "ACTIVE",
        item.variable,
        None if longest is None else TimeOut(longest),
        tuple(calls),
    )


# -- modes --------------------------------------------------------------------------------------------------------


def mode_in(interfaces: Iterable[ModeInterface], table: Table) -> ModeIn | None:
    """The mode that the function receives; None if it receives none."""
    item = _interface("In", interfaces)
    if item is None:
        return None
    sent, codes = _numbers(item, table)
    return ModeIn(
        item.name,
        {number: name for name, number in sent.items()},
        codes,
        item.initial if item.initial in item.modes else item.modes[0],
        item.variable,
        item.unknown_action == "Initial",
        item.unknown_error,
    )


def mode_out(interfaces: Iterable[ModeInterface], table: Table) -> ModeOut | None:
    """The mode that the function reports; None if no variable has it."""
    item = _interface("Out", interfaces)
    if item is None or item.variable is None:
        return None
    sent, codes = _numbers(item, table)
    return ModeOut(item.name, {codes[name]: sent[name] for name in item.modes}, item.variable)


def _interface(direction: str, interfaces: Iterable[ModeInterface]) -> ModeInterface | None:
    return next((each for each in interfaces if each.direction == direction and each.modes), None)


def _numbers(item: ModeInterface, table: Table) -> tuple[dict[str, int], dict[str, int]]:
    """Numbers of the modes that are received and sent, and those of the code."""
    symbols = _symbols(item.datatype, table)
    sent = {name: symbols.get(name, index) for index, name in enumerate(item.modes)}
    own = {each.symbol: each.value for each in item.values or ()}
    return sent, {name: own.get(name, number) for name, number in sent.items()}
