"""Messages that a node sends, with what the core says, outside of its lock."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from sigcat.adapter.core.plan import Port
from sigcat.adapter.ros2.cpp.names import is_plain, short, table
from sigcat.adapter.ros2.plan import Fixed, NodePlan, Publisher, SentField
from sigcat.function.document.text_filters import c_string


class Filled(NamedTuple):
    """A field of a message, and the value of the core that fills it."""

    of: SentField
    is_plain: bool
    """Whether it is one number."""
    table: str
    """Texts of an enumeration; empty if the field has no text."""
    active: int | None
    """The number of the core for an active state, where the message has 0 and 1."""


class TakenBack(NamedTuple):
    """A value that another call of the function takes, too: no message is needed for that."""

    place: str
    port: Port
    is_pointer: bool


class Sent(NamedTuple):
    """A message: its publisher, and how it is filled."""

    member: str
    type: str
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
    statuses: Sequence[str]
    """Places of the core for which diagnostics are sent at once."""


def sending_of(node: NodePlan) -> Sending:
    """All that it sends."""
    return Sending(
        any(each.stamp for each in node.publishers),
        [_sent(each, node) for each in node.publishers],
        [given.place for each in node.publishers if each.is_status for given in each.gives],
    )


def _sent(publisher: Publisher, node: NodePlan) -> Sent:
    return Sent(
        publisher.member,
        short(publisher.message, node),
        publisher.gives[0].place if publisher.is_queue else "",
        publisher.stamp,
        [Fixed(each.field, _literal(each.value)) for each in publisher.fixed],
        [_filled(each) for each in publisher.gives],
        publisher.is_status,
        [_taken_back(port, each) for each in publisher.gives for port in each.own_ports],
    )


def _literal(value: Any) -> str:
    """A value of a document, as C++ writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, int | float) else c_string(value)


def _filled(given: SentField) -> Filled:
    assert [number for _, number in given.numbers] in ([], [0, 1])
    active = given.numbers[1][0] if given.numbers else None
    return Filled(given, is_plain(given.wire), table(given.place) if given.symbols else "", active)


def _taken_back(port: Port, given: SentField) -> TakenBack:
    return TakenBack(given.place, port, port.wire.is_struct and port.wire.length is None)
