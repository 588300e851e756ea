"""Messages that a node sends, with what the core says, outside of its lock."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from sigcat.adapter.core.plan import Port
from sigcat.adapter.ros2.cpp.layout import any_of, call
from sigcat.adapter.ros2.cpp.names import CORE, core_function, is_plain, short, table
from sigcat.adapter.ros2.plan import Fixed, Given, NodePlan, Publisher
from sigcat.function.document.text_filters import c_string


class Filled(NamedTuple):
    """A field of a message, and the value of the core that fills it."""

    comment: str
    field: str
    value: str
    is_plain: bool
    """Whether it is one number."""
    table: str
    """Texts of an enumeration; empty if the field has no text."""
    number_field: str | None
    """The field for its number, beside its text."""
    active: int | None
    """The number of the core for an active state, where the message has 0 and 1."""


class TakenBack(NamedTuple):
    """A value that another call of the function takes, too: no message is needed for that."""

    place: str
    received: str
    """The call of the core."""
    wakes: bool
    """Whether it makes a call due."""


class Sent(NamedTuple):
    """A message: its publisher, and how it is filled."""

    member: str
    type: str
    head: str
    """The condition that it is due."""
    queue: str
    """The place of the core that has several values, of which each is a message; empty if there is none."""
    stamp: str | None
    fixed: Sequence[Fixed]
    """Fields with their values in C++."""
    gives: Sequence[Filled]
    is_status: bool
    taken_back: Sequence[TakenBack]


class Sending(NamedTuple):
    """All messages of a node."""

    has_stamp: bool
    messages: Sequence[Sent]
    told_head: str
    """The condition for diagnostics at once: a status is due. Empty if there is none."""


def sending_of(node: NodePlan) -> Sending:
    """All that it sends."""
    due = [f"due.{given.place}" for each in node.publishers if each.is_status for given in each.gives]
    return Sending(
        any(each.stamp for each in node.publishers),
        [_sent(each, node) for each in node.publishers],
        any_of(due) if due else "",
    )


def _sent(publisher: Publisher, node: NodePlan) -> Sent:
    queue = publisher.gives[0].place if publisher.is_queue else ""
    values = {each.place: f"out.{queue}.values[i]" if queue else f"out.{each.place}" for each in publisher.gives}
    return Sent(
        publisher.member,
        short(publisher.message, node),
        any_of([f"due.{each.place}" for each in publisher.gives]),
        queue,
        publisher.stamp,
        [Fixed(each.field, _fixed(each.value)) for each in publisher.fixed],
        [_filled(each, values[each.place]) for each in publisher.gives],
        publisher.is_status,
        [_taken_back(port, each, values[each.place], node) for each in publisher.gives for port in each.own_ports],
    )


def _fixed(value: Any) -> str:
    """A value of a document, as C++ writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, int | float) else c_string(value)


def _filled(given: Given, value: str) -> Filled:
    if given.numbers:
        (first, one), (_, other) = given.numbers
        assert (one, other) == (0, 1), first
    return Filled(
        given.comment,
        given.field,
        value,
        is_plain(given.wire),
        table(given.place) if given.symbols else "",
        given.number_field,
        given.numbers[1][0] if given.numbers else None,
    )


def _taken_back(port: Port, given: Given, value: str, node: NodePlan) -> TakenBack:
    argument = f"&{value}" if port.wire.is_struct and port.wire.length is None else value
    received = call(core_function(node, f"Receive_{port.name}"), [CORE, argument, "clock_->now()"], levels=3)
    return TakenBack(given.place, received, bool(port.triggers))
