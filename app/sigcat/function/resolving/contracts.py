"""Interfaces that a call reads and writes: signals, queues, parameters, errors, safety reactions and methods."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

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
    lists: Mapping[str, Sequence[Part[Any]]] = {
        "signals": _of_kind(Signal, there),
        "queues": _of_kind(DataQueue, there),
        "parameters": each(item.parameters, (*at, "parameters"), context, parameter),
        "errors": each(item.errors, (*at, "errors"), context, error),
        "safety_reactions": each(item.safety_reactions, (*at, "safetyReactions"), context, safety_reaction),
        "methods": each(item.methods, (*at, "methods"), context, method),
        "absent_signals": _of_kind(Signal, absent),
        "absent_queues": _of_kind(DataQueue, absent),
    }
    made = Contract(type=item.contract, **{field: values_of(parts) or None for field, parts in lists.items()})
    own: dict[str | int, Origin] = {"Type": Origin((*at, "contract"))} if item.contract is not None else {}
    origins: dict[str | int, Origin] = {
        Contract.model_fields[field].alias or field: origin_of(parts, at) for field, parts in lists.items()
    }
    is_empty = not any(origin.parts for origin in origins.values())
    missing = (*missing_in(lists["parameters"]), *missing_in(lists["errors"]))
    return Part(None if is_empty else made, Origin(at, {**own, **origins}), missing)


def _of_kind(kind: type, data: Iterable[Part[Signal | DataQueue]]) -> list[Part[Signal | DataQueue]]:
    return [Part(part.value, part.origin) for part in data if isinstance(part.value, kind)]
