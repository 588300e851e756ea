"""Publishers and subscriptions of a node, which it creates while it is configured."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import WireType
from sigcat.adapter.ros2.cpp.layout import call
from sigcat.adapter.ros2.cpp.names import CORE, core_function, is_plain, short, table
from sigcat.adapter.ros2.plan import NodePlan, Publisher, Subscription, Taken
from sigcat.function.document.text_filters import c_string
from sigcat.integration.ros2.model import QualityOfService


class Advertised(NamedTuple):
    """A publisher: its member, without the end of the name, and the expression that makes it."""

    member: str
    made: str


class Received(NamedTuple):
    """A value of a message, and the call of the core that receives it."""

    comment: str
    field: str
    wire: WireType
    variable: str
    """Variable that it is copied to; empty for one number."""
    table: str
    """Texts of an enumeration; empty if the field has a number."""
    nameless: int | None
    """The number of a text that has no name."""
    received: str


class Subscribed(NamedTuple):
    """A subscription, with the values that its callback stores."""

    type: str
    topic: str
    quality: str
    takes: Sequence[Received]
    wakes: bool
    """Whether a value may make a call due."""


class Connections(NamedTuple):
    """All topics of a node."""

    publishers: Sequence[Advertised]
    subscriptions: Sequence[Subscribed]


def connections_of(node: NodePlan) -> Connections:
    """All that it sends and takes."""
    return Connections(
        [_advertised(each, node) for each in node.publishers],
        [_subscribed(each, node) for each in node.subscriptions],
    )


def _advertised(publisher: Publisher, node: NodePlan) -> Advertised:
    arguments = ["*this", "topics_", c_string(node.private(publisher.topic)), _quality(publisher.quality), "receiving_"]
    made = f"std::make_unique<CountingPublisher<{short(publisher.message, node)}>>"
    return Advertised(publisher.member, call(made, arguments, levels=2))


def _subscribed(subscription: Subscription, node: NodePlan) -> Subscribed:
    return Subscribed(
        short(subscription.message, node),
        node.private(subscription.topic),
        _quality(subscription.quality),
        [_received(each, node) for each in subscription.takes],
        any(each.wakes for each in subscription.takes),
    )


def _received(taken: Taken, node: NodePlan) -> Received:
    field, variable = f"message.{taken.field}", "" if is_plain(taken.wire) else f"taken_{taken.place}"
    value = f"{'' if taken.wire.length is not None else '&'}{variable}" if variable else _number(taken, field)
    return Received(
        taken.comment,
        field,
        taken.wire,
        variable,
        table(taken.place) if taken.symbols else "",
        taken.nameless,
        call(core_function(node, f"Receive_{taken.place}"), [CORE, value, "clock_->now()"], levels=4),
    )


def _number(taken: Taken, field: str) -> str:
    """One number, as the core takes it."""
    if taken.symbols:
        return f"static_cast<{taken.wire.c}>(\n  symbol_number({table(taken.place)}, {field}, {taken.nameless}))"
    return _renumbered(taken, field) if taken.numbers else field


def _renumbered(taken: Taken, field: str) -> str:
    """A state by its name, where the core has other numbers."""
    (inactive, first), (active, second) = taken.numbers
    unnamed = next(number for number in range(256) if number not in (first, second))
    return f"{field} == {active}U ? {second}U : {field} == {inactive}U ? {first}U : {unnamed}U"


def _quality(of: QualityOfService) -> str:
    """Quality of service in C++."""
    parts = [
        f"rclcpp::QoS(rclcpp::KeepLast({of.depth}))",
        "reliable()" if of.reliability == "reliable" else "best_effort()",
        "transient_local()" if of.durability == "transient_local" else "durability_volatile()",
    ]
    if of.deadline is not None:
        parts.append(f"deadline({_duration(of.deadline)})")
    if of.liveliness == "manual_by_topic":
        parts.append("liveliness(rclcpp::LivelinessPolicy::ManualByTopic)")
        if of.lease_duration is not None:
            parts.append(f"liveliness_lease_duration({_duration(of.lease_duration)})")
    line = ".".join(parts)
    return line if len(line) < 92 else f"{'.'.join(parts[:3])}\n.{'.'.join(parts[3:])}"


def _duration(milliseconds: float) -> str:
    if milliseconds == int(milliseconds):
        return f"std::chrono::milliseconds({int(milliseconds)})"
    return f"std::chrono::nanoseconds({round(milliseconds * 10**6)})"
