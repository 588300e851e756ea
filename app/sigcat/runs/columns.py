"""Parts of a run that belong to one function: the columns that it sends and receives, and its calls."""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.cores import plans
from sigcat.adapter.host.connections import Entry, Exit, Member, connect
from sigcat.adapter.host.host_plan import Kind
from sigcat.adapter.host.shapes import Shape
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import data
from sigcat.integration.sent_values import sent


class Column(NamedTuple):
    """A column that has to do with the function."""

    name: str
    kind: Kind
    shape: Shape
    unit: str
    is_sent: bool
    """Whether the function sends it; if not, another function of the run does, and this one receives it."""
    is_shared: bool
    """Whether only one function sends it. A safety reaction is decided by each function for itself."""
    good: int | None
    """The number that says that all is well, of an error and of a safety reaction."""
    limits: tuple[float, ...] = ()
    """Smallest and largest valid value that the function declares, in the unit of the column."""
    timeout: int = 0
    """Longest valid time between two values, in ns; 0 without one."""


class FunctionColumns(NamedTuple):
    """All of them."""

    columns: Mapping[str, Column]
    """By name, what is sent first."""
    calls: tuple[str, ...]


def columns_of(function: ResolvedFunction) -> FunctionColumns:
    """The columns of a function. Raises InputRefused if it has no core, and so no run."""
    (planned,) = plans((function,))
    plan = planned.plan
    connections = connect((Member(function, plan, Path()),))
    found = [
        *(_sent(each) for each in connections.exits),
        *(_received(each) for each in connections.entries if not each.is_answer),
    ]
    declared = {item.vss_path or item.name: item for _, _, item in data(function.function)}
    columns = {each.name: _limited(each, declared.get(each.name)) for each in reversed(found)}
    ordered = {each.name: columns[each.name] for each in found}
    return FunctionColumns(ordered, tuple(dict.fromkeys(call.interface for call in plan.calls)))


def _sent(each: Exit) -> Column:
    return Column(each.name, each.kind, each.shape, each.unit, True, each.is_shared, each.good)


def _received(each: Entry) -> Column:
    return Column(each.names[0], each.kind, each.shape, each.unit, False, True, each.good)


def _limited(column: Column, declared: Signal | DataQueue | None) -> Column:
    """Add the declared range and time-out to a column."""
    if declared is None:
        return column
    limits = (sent(declared.min, declared), sent(declared.max, declared))
    timeout = 0 if column.is_sent else round((milliseconds(declared.timeout) or 0) * 1_000_000)
    return column._replace(limits=tuple(sorted(each for each in limits if each is not None)), timeout=timeout)
