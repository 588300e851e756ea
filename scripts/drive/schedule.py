"""Values that change at times that are known beforehand."""

from collections.abc import Sequence
from itertools import pairwise
from typing import TypeVar

Value = TypeVar("Value")

Changes = Sequence[tuple[float, Value]]
"""Times in seconds, each with the value from then on."""


def at(changes: Changes[Value], time: float) -> Value:
    """The value at a time; the first one, too, before its time."""
    return next((value for begin, value in reversed(changes) if begin <= time), changes[0][1])


def between(points: Sequence[tuple[float, float]], time: float) -> float:
    """The value at a time, on the straight line between the points before and after it."""
    for (begin, first), (end, second) in pairwise(points):
        if time < end:
            return first + (second - first) * max(0.0, (time - begin) / (end - begin))
    return points[-1][1]
