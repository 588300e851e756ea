"""Ranges of signals, as their datatypes hold them."""

import struct
from math import inf
from typing import NamedTuple

from sigcat.adapter.host.shapes import Array, Number, Shape, Value

_SINGLE = struct.Struct("f")


class Range(NamedTuple):
    """The range of a signal, as its datatype holds it."""

    least: float = -inf
    greatest: float = inf

    def holds(self, value: Value) -> bool:
        """Whether each number of a value is within it; NaN is not."""
        return all(self.least <= number <= self.greatest for number in (value if isinstance(value, list) else (value,)))


NO_RANGE = Range()


def range_of(least: float | None, greatest: float | None, shape: Shape) -> Range | None:
    """Return the range of values of a shape; None if it has none."""
    element = shape.element if isinstance(shape, Array) else shape
    if not isinstance(element, Number) or element.symbols or (least is None and greatest is None):
        return None
    held = Range(-inf if least is None else least, inf if greatest is None else greatest)
    return Range(*map(_single, held)) if element.datatype == "float" else held


def _single(limit: float) -> float:
    try:
        number: float = _SINGLE.unpack(_SINGLE.pack(limit))[0]
    except OverflowError:
        return limit
    return number
