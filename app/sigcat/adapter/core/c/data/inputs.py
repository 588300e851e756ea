"""Inputs: received from any thread, and taken by the snapshots of calls (sections 2 to 5)."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.values.c_values import Transfer, Way, merged, to_variable, transfer
from sigcat.adapter.core.c.values.literals import literal
from sigcat.adapter.core.plan import Call, Input, Leaf, Port
from sigcat.function.function_json.conversion import IDENTITY

UINT8_MOST = 255


class NotZero(NamedTuple):
    """Whether a number of a variable, or any of an array, is not 0."""

    length: int | None
    condition: str


class InputPlan(NamedTuple):
    """An input of a call."""

    item: Input
    name: str
    """Ending of the names of its functions: `Step_VehSpd`."""
    place: str
    """Member with its state: `self->Step.in.VehSpd`."""
    source: str
    """The received value; of a queue, the one that waits longest."""
    received: Transfer
    """From there to the variable: it is checked there."""
    taken: Transfer
    """From the value of the call to the variable."""
    ways: Sequence[Way]
    kept_at: str
    """Index of a kept value."""
    holds_init: bool
    not_zero: Sequence[NotZero]
    """For an error that is reset by it."""
    count_type: str
    """Type of the number of values, which fits whatever holds it."""


def input_plan(call: Call, item: Input, scope: Scope) -> InputPlan:
    """An input, as functions of the adapter take it."""
    name, place = f"{call.name}_{item.named.name}", f"self->{call.name}.in.{item.named.name}"
    many = item.places > 1
    value = f"self->received.{item.port}.value"
    received = to_variable(
        f"{place}.values[{place}.queue.first]" if item.queue else value,
        f"{item.variable}[place]" if many else item.variable,
        name,
        item.named.pointer,
        scope,
    )
    ends = received._replace(source=f"{place}.kept[{'place' if many else '0'}]" if item.keeps else value)
    ways = [*_ways(item, place)]
    taken = transfer(item.value, ends, {way.kind for way in ways})
    return InputPlan(
        item=item,
        name=name,
        place=place,
        source=received.source,
        received=transfer(item.value, received),
        taken=taken,
        ways=merged(ways, taken),
        kept_at="taken" if many else "0",
        holds_init=item.is_direct
        and not item.is_absent
        and holds_init(next(port for port in scope.plan.ports if port.name == item.port)),
        not_zero=[_not_zero(leaf, item, scope) for leaf in item.value.leaves] if item.is_reset else [],
        count_type="uint8_t" if item.places <= UINT8_MOST else "uint16_t",
    )


def _ways(item: Input, place: str) -> Iterator[Way]:
    """Numbers for the variable, by the origin of the value."""
    if item.is_absent:
        yield Way("", "init")
        return
    late = item.time_out.substitute if item.time_out else "Last"
    origin = f"{place}.origin[{'place' if item.places > 1 else '0'}]" if item.queue else "origin"
    if item.queue and late != "Last":
        yield Way(f"{place}.clock.is_late", late.lower())
    yield Way(f"{origin} == SIGCAT_RECEIVED", "converted")
    if item.value.is_replaced:
        yield Way(f"{origin} == SIGCAT_REPLACEMENT", "replacement")
    if not item.queue and late == "Default":
        yield Way(f"{origin} == SIGCAT_DEFAULT", "default")
    yield Way("", "init")


def _not_zero(leaf: Leaf, item: Input, scope: Scope) -> NotZero:
    target, element = f"{item.variable}{'[place]' if item.places > 1 else ''}{leaf.target}", leaf.element
    number = f"({element.target.c}){target}" if scope.is_cpp and element.is_enumeration else target
    zero = literal(0, element.target)
    return NotZero(leaf.length, number if element.target.is_boolean else f"({number} != {zero})")


def holds_init(port: Port) -> bool:
    """Whether the start value can be among the received ones: the call sees the very same bits."""
    return received_init(port) is not None


def received_init(port: Port) -> str | None:
    """The number that the conversion makes the start value of, to the bit; None if none is known for certain."""
    items = [item for _, item in port.consumers]
    if len(items) > 1 or not items[0].is_direct:
        return None
    (leaf,) = items[0].value.leaves
    element, init = leaf.element, leaf.init[0]
    if element.source == element.target and element.conversion == IDENTITY:
        return literal(init, element.target)
    keeps_zero = not element.conversion.offset and element.conversion.factor > 0  # a negative factor makes it -0.0
    return literal(0, element.source) if init == 0 and keeps_zero else None
