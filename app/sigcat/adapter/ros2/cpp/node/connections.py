"""Publishers and subscriptions of a node, which it creates while it is configured."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.cpp.names import table
from sigcat.adapter.ros2.plan import NodePlan, Publisher, ReceivedField, Subscription
from sigcat.integration.ros2.model import QualityOfService


class Duration(NamedTuple):
    """A duration of `std::chrono`."""

    unit: str
    ticks: int


class Quality(NamedTuple):
    """Quality of service, with its durations."""

    of: QualityOfService
    deadline: Duration | None
    lease: Duration | None
    """Lease duration, if the publisher itself says that it lives."""


class Advertised(NamedTuple):
    """A publisher."""

    of: Publisher
    quality: Quality


class Received(NamedTuple):
    """A value of a message, which the core receives."""

    of: ReceivedField
    table: str
    """Texts of an enumeration; empty if the field has a number."""
    unnamed: int | None
    """The number for the core of a state that has no name; None where both sides have the same numbers."""


class Subscribed(NamedTuple):
    """A subscription, with the values that its callback stores."""

    of: Subscription
    quality: Quality
    takes: Sequence[Received]


def advertised(node: NodePlan) -> Sequence[Advertised]:
    """All publishers."""
    return [Advertised(each, _quality(each.quality)) for each in node.publishers]


def subscribed(node: NodePlan) -> Sequence[Subscribed]:
    """All subscriptions."""
    return [Subscribed(each, _quality(each.quality), [*map(_received, each.takes)]) for each in node.subscriptions]


def _received(taken: ReceivedField) -> Received:
    numbers = {number for _, number in taken.numbers}
    unnamed = next(number for number in range(256) if number not in numbers) if numbers else None
    return Received(taken, table(taken.place) if taken.symbols else "", unnamed)


def _quality(of: QualityOfService) -> Quality:
    is_manual = of.liveliness == "manual_by_topic"
    return Quality(of, _duration(of.deadline), _duration(of.lease_duration) if is_manual else None)


def _duration(milliseconds: float | None) -> Duration | None:
    if milliseconds is None:
        return None
    if milliseconds == int(milliseconds):
        return Duration("milliseconds", int(milliseconds))
    return Duration("nanoseconds", round(milliseconds * 10**6))
