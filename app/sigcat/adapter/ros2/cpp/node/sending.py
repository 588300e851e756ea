"""Messages that a node sends, with what the core says, outside of its lock."""

from collections.abc import Sequence
from typing import Any, NamedTuple

from sigcat.adapter.core.plan import Port
from sigcat.adapter.ros2.cpp.names import table
from sigcat.adapter.ros2.plan import Fixed, NodePlan, Publisher, SentField
from sigcat.function.document.text_filters import c_string


class Filled(NamedTuple):
    """A field of a message, and the value of the core that fills it."""

    of: SentField
    table: str
    """Texts of an enumeration; empty if the field has no text."""
    active: int | None
    """The number of the core for an active state, where the message has 0 and 1."""


class TakenBack(NamedTuple):
    """A value that another call of the function takes, too: no message is needed for that."""

    place: str
    port: Port


class Sent(NamedTuple):
    """A message: its publisher, and how it is filled."""

    of: Publisher
    queue: str
    """The place of the core that has several values, of which each is a message; empty if there is none."""
    fixed: Sequence[Fixed]
    """Fields with their values in C++."""
    gives: Sequence[Filled]
    taken_back: Sequence[TakenBack]


def messages_of(node: NodePlan) -> Sequence[Sent]:
    """All that it sends."""
    return [_sent(each) for each in node.publishers]


def _sent(publisher: Publisher) -> Sent:
    return Sent(
        publisher,
        publisher.gives[0].place if publisher.is_queue else "",
        [Fixed(each.field, _literal(each.value)) for each in publisher.fixed],
        [_filled(each) for each in publisher.gives],
        [TakenBack(each.place, port) for each in publisher.gives for port in each.own_ports],
    )


def _literal(value: Any) -> str:
    """A value of a document, as C++ writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, int | float) else c_string(value)


def _filled(given: SentField) -> Filled:
    assert [number for _, number in given.numbers] in ([], [0, 1])
    active = given.numbers[1][0] if given.numbers else None
    return Filled(given, table(given.place) if given.symbols else "", active)
