"""Interfaces that a call reads and writes: signals, queues, parameters, errors, safety reactions and methods."""

from collections.abc import Iterable

from sigcat.function.declaration.declaration import RunnableItem
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.function_json.runnable import Contract
from sigcat.function.resolving.absent import is_absent
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.data_interfaces import data_interface, parameter
from sigcat.function.resolving.methods import method
from sigcat.function.resolving.part import Part, each, missing_in, origin_of, values_of
from sigcat.function.resolving.status_interfaces import error, safety_reaction


def contract(item: RunnableItem, at: Pointer, context: Context) -> Part[Contract]:
    """The contract of a call; without a value if the call reads and writes nothing."""
    data = each(item.data, (*at, "data"), context, data_interface)
    there, absent = (
        [part for one, part in zip(item.data, data, strict=True) if is_absent(one, context) == are_absent]
        for are_absent in (False, True)
    )
    signals, queues = _signals(there), _queues(there)
    absent_signals, absent_queues = _signals(absent), _queues(absent)
    parameters = each(item.parameters, (*at, "parameters"), context, parameter)
    errors = each(item.errors, (*at, "errors"), context, error)
    reactions = each(item.safety_reactions, (*at, "safetyReactions"), context, safety_reaction)
    methods = each(item.methods, (*at, "methods"), context, method)
    made = Contract(
        type=item.contract,
        signals=values_of(signals) or None,
        queues=values_of(queues) or None,
        methods=values_of(methods) or None,
        parameters=values_of(parameters) or None,
        errors=values_of(errors) or None,
        safety_reactions=values_of(reactions) or None,
        absent_signals=values_of(absent_signals) or None,
        absent_queues=values_of(absent_queues) or None,
    )
    own: dict[str | int, Origin] = {"Type": Origin((*at, "contract"))} if item.contract is not None else {}
    lists: dict[str | int, Origin] = {
        "SignalList": origin_of(signals, at),
        "DataQList": origin_of(queues, at),
        "MethodList": origin_of(methods, at),
        "ParameterList": origin_of(parameters, at),
        "ErrorList": origin_of(errors, at),
        "SafetyReactionList": origin_of(reactions, at),
        "AbsentSignalList": origin_of(absent_signals, at),
        "AbsentDataQList": origin_of(absent_queues, at),
    }
    is_empty = not any(origin.parts for origin in lists.values())
    return Part(
        None if is_empty else made, Origin(at, {**own, **lists}), (*missing_in(parameters), *missing_in(errors))
    )


def _signals(data: Iterable[Part[Signal | DataQueue]]) -> list[Part[Signal]]:
    return [Part(part.value, part.origin) for part in data if isinstance(part.value, Signal)]


def _queues(data: Iterable[Part[Signal | DataQueue]]) -> list[Part[DataQueue]]:
    return [Part(part.value, part.origin) for part in data if isinstance(part.value, DataQueue)]
