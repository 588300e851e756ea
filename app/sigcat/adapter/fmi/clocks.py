"""Clocks of the calls of a function, for scheduled execution."""

from sigcat.adapter.core.plan import Call
from sigcat.adapter.fmi.variables import Layout, free_name
from sigcat.adapter.host.connections import Connections
from sigcat.integration.fmi.model import FmuClock


def clocks_of(connections: Connections, layout: Layout) -> tuple[FmuClock, ...]:
    """A clock for each call of the one function of an FMU, in the order of its calls. Priorities are the order in which calls are due."""
    (member,) = connections.members
    order = [each.name for each in member.plan.due]
    taken = {each.name for each in layout.variables}
    return tuple(
        _clock(each, len(layout.variables) + index, order.index(each.name), taken)
        for index, each in enumerate(member.plan.steps)
    )


def _clock(call: Call, reference: int, priority: int, taken: set[str]) -> FmuClock:
    return FmuClock(
        name=free_name(call.interface, "clock", taken),
        reference=reference,
        interval=call.cycle,
        shift=call.offset,
        priority=priority,
        description=call.description,
    )


def is_inside(call: Call, connections: Connections) -> bool:
    """Whether a signal that the function itself sends triggers the call: no importer knows when."""
    inside = {connections.entries[target].receiver for route in connections.routes for target in route}
    return bool(call.triggers & inside)
