"""Errors of a function, with everything that makes them present (section 6), and its safety reactions (section 7)."""

from collections.abc import Iterable, Iterator, Mapping
from graphlib import CycleError, TopologicalSorter
from typing import NamedTuple

from sigcat.adapter.core.identifiers import identifier, unique
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import (
    CONDITIONS,
    Call,
    Cause,
    Error,
    ForeignError,
    Input,
    ModeIn,
    Named,
    Parameter,
    Reaction,
    WireType,
)
from sigcat.adapter.core.planning import Context, ListedCall, expression, nanoseconds
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.datatypes.datatype import EnumerationValue
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction

RESTART = "Restart"


Resets = Mapping[str, Mapping[str, str]]
"""Places of flags that tell whether an input is not 0: by its name, and the call."""
Names = Mapping[str, str]
"""Identifiers by the names of interfaces."""


class Declared(NamedTuple):
    """An error or a reaction, where it stands, and the call that lists it."""

    call: ListedCall
    at: Pointer
    item: "ErrorInterface | SafetyReaction"


def short_names(items: Iterable[Declared], function: str, ending: str, taken: set[str]) -> Names:
    """The middle of the names of errors or reactions: `Acc_RangeError_ErrorSts` of Acc → `RangeError`. `taken` grows."""
    names: dict[str, str] = {}
    for name in dict.fromkeys(each.item.name for each in items):
        names[name] = unique(identifier(name.removeprefix(f"{function}_").removesuffix(ending)), taken)
        taken.add(names[name])
    return names


def causes_of(
    steps: Iterable[Call], calls: Iterable[Call], mode: ModeIn | None, parameters: Iterable[Parameter]
) -> dict[str, list[Cause]]:
    """Causes of errors except their own variables, by interface name. `calls` are all calls, init included."""
    found: dict[str, list[Cause]] = {}
    for name, cause in (*_of_steps(steps), *_of_graph(calls), *_of_others(mode, parameters)):
        if name is not None:
            found.setdefault(name, []).append(cause)
    return found


def _of_steps(calls: Iterable[Call]) -> Iterator[tuple[str | None, Cause]]:
    for call in calls:
        for item in call.inputs:
            yield from _of_input(call.name, item)
        for output in call.outputs:
            place = f"{call.name}.out.{output.named.name}"
            yield output.range_error, Cause(f"{place}.range", call.name, is_late=True)
            if output.queue:
                yield output.queue.overflow_error, Cause(f"{place}.overflow", call.name, is_late=True)
        yield call.overrun_error, Cause(f"{call.name}.overrun", call.name, is_late=False)
        if call.alive:
            yield call.alive.error, Cause(f"{call.name}.alive.verdict", call.name, is_late=True, is_supervised=True)
        if call.deadline:
            yield call.deadline.error, Cause(f"{call.name}.deadline", call.name, is_late=True, is_supervised=True)


def _of_graph(calls: Iterable[Call]) -> Iterator[tuple[str | None, Cause]]:
    for call in calls:
        if call.logical:
            yield call.logical.error, Cause(f"checkpoint.{call.name}", call.name, is_late=False)


def _of_input(call: str, item: Input) -> Iterator[tuple[str | None, Cause]]:
    place = f"{call}.in.{item.named.name}"
    for field, error in item.errors.items():
        condition = CONDITIONS[field]
        if condition.verdict:
            is_late = condition.is_of_taken and item.is_immediate
            yield error, Cause(f"{place}.{condition.verdict}", call, is_late)
        else:
            yield error, Cause("", call, is_late=False, verdict="PRESENT" if item.is_absent else "ABSENT")
    if item.queue and not item.is_absent:
        yield item.queue.overflow_error, Cause(f"{place}.overflow", call, is_late=False)


def _of_others(mode: ModeIn | None, parameters: Iterable[Parameter]) -> Iterator[tuple[str | None, Cause]]:
    if mode:
        yield mode.unknown_error, Cause("mode.unknown", None, is_late=False)
    for parameter in parameters:
        yield parameter.range_error, Cause(f"parameter.{parameter.named.name}.range", None, is_late=False)


# -- errors -------------------------------------------------------------------------------------------------------


def errors_of(
    declared: Iterable[Declared], causes: Mapping[str, list[Cause]], resets: Resets, names: Names,
    context: Context,
) -> tuple[Error, ...]:  # fmt: skip
    """The errors, each after those that it depends on. `resets` are places of verdicts, by the names of signals."""
    items = _by_name(declared)
    made = {name: _error(listed, causes.get(name, ()), resets, names, context) for name, listed in items.items()}
    return tuple(made[name] for name in _in_order(items))


def _by_name(declared: Iterable[Declared]) -> dict[str, list[Declared]]:
    items: dict[str, list[Declared]] = {}
    for each in declared:
        items.setdefault(each.item.name, []).append(each)
    return items


def _in_order(items: Mapping[str, list[Declared]]) -> tuple[str, ...]:
    """Names, each after its dependencies; in the order of the file where that makes no difference, or is a circle."""
    graph = {
        name: [other for other in item.dependencies if other in items and other != name]
        for name, ((_, _, item), *_) in items.items()
        if isinstance(item, ErrorInterface)
    }
    try:
        return tuple(TopologicalSorter(graph).static_order())
    except CycleError:
        return tuple(items)


def _error(listed: list[Declared], causes: Iterable[Cause], resets: Resets, names: Names, context: Context) -> Error:
    _, at, item = listed[0]
    assert isinstance(item, ErrorInterface)
    name = Named(names[item.name], item.vss_path or item.name, at)
    steps = [each.call.name for each in listed if each.call.is_step]
    owner = steps[0] if steps else None
    variable = expression(item.variable, item.name, (*at, "Variable"), context)
    status = expression(item.status_variable, item.name, (*at, "StatusVariable"), context)
    written = (Cause(f"error.{name.name}.variable", owner, is_late=True),) if variable else ()
    others = [other for other in item.dependencies if other != item.name]
    wire, numbers = status_type(item.datatype, {"PASSED": 0, "FAILED": 1}, context)
    waits = None if item.reset in (None, RESTART) else resets.get(item.reset or "", {})
    place = None if waits is None else waits.get(owner or "") or next(iter(waits.values()), None)
    return Error(
        named=name,
        wire=wire,
        passed=numbers["PASSED"],
        failed=numbers["FAILED"],
        call=owner,
        calls=tuple(dict.fromkeys(steps)),
        causes=(*causes, *written),
        variable=variable,
        status_variable=status,
        maturation=nanoseconds(item.maturation_time, (*at, "MaturationTime"), context) or 0,
        reset=nanoseconds(item.reset_time, (*at, "ResetTime"), context) or 0,
        waits_for_restart=item.reset is not None and place is None,
        reset_input=place,
        dependencies=tuple(names[other] for other in others if other in names),
        foreign=tuple(identifier(other) for other in others if other not in names),
        occurrence_limit=item.occurrence_count_limit,
        ignition_limit=item.ignition_count_limit,
    )


def status_type(reference: str, usual: Mapping[str, int], context: Context) -> tuple[WireType, dict[str, int]]:
    """The type of a status, and the numbers of its states; the usual ones where its datatype does not name them."""
    datatype = context.datatypes.get(reference)
    found = type_of_c(datatype.c_definition) if datatype else None
    symbols: tuple[EnumerationValue, ...] = (datatype.symbols if datatype else None) or ()
    known = {each.symbol.upper(): each.value for each in symbols}
    numbers = {name: known.get(name, number) for name, number in usual.items()}
    listed = tuple((each.symbol, each.value) for each in symbols) or tuple(usual.items())
    return WireType(found.c if found else "uint8_t", symbols=listed), numbers


def foreign_errors(errors: Iterable[Error], reactions: Iterable[Reaction]) -> tuple[ForeignError, ...]:
    """Errors of others on which errors or reactions depend, each once, in the usual type of a status."""
    names = dict.fromkeys(name for items in (errors, reactions) for each in items for name in each.foreign)
    symbols = (("PASSED", 0), ("FAILED", 1))
    return tuple(ForeignError(name, name, WireType("uint8_t", symbols=symbols)) for name in names)


# -- safety reactions ---------------------------------------------------------------------------------------------


def reactions_of(declared: Iterable[Declared], own: Names, names: Names, context: Context) -> tuple[Reaction, ...]:
    """The safety reactions, each once, with all calls that list it. `own` are names of errors, `names` its own."""
    return tuple(_reaction(listed, own, names, context) for listed in _by_name(declared).values())


def _reaction(listed: list[Declared], own: Names, names: Names, context: Context) -> Reaction:
    _, at, item = listed[0]
    assert isinstance(item, SafetyReaction)
    wire, numbers = status_type(item.datatype, {"INACTIVE": 0, "ACTIVE": 1}, context)
    variable = expression(item.variable, item.name, (*at, "Variable"), context)
    return Reaction(
        named=Named(names[item.name], item.vss_path or item.name, at),
        wire=wire,
        inactive=numbers["INACTIVE"],
        active=numbers["ACTIVE"],
        initial=numbers.get((item.initial or "INACTIVE").upper(), numbers["INACTIVE"]),
        calls=tuple(dict.fromkeys(each.call.name for each in listed if each.call.is_step)),
        errors=tuple(own[name] for name in item.errors if name in own),
        foreign=tuple(identifier(name) for name in item.errors if name not in own),
        variable=variable,
        time_out=nanoseconds(item.timeout, (*at, "Timeout"), context),
    )


def status_items(calls: Iterable[ListedCall]) -> tuple[list[Declared], list[Declared]]:
    """Errors and reactions that calls list."""
    errors, reactions = [], []
    for each in calls:
        for index, contract in enumerate(each.call.contracts or ()):
            base = (*each.at, "funcContractList", index)
            errors += [Declared(each, (*base, "ErrorList", n), item) for n, item in enumerate(contract.errors or ())]
            reactions += [
                Declared(each, (*base, "SafetyReactionList", n), item)
                for n, item in enumerate(contract.safety_reactions or ())
            ]
    return errors, reactions
