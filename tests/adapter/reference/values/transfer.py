"""Transfer of a value from one side to the other: limits, conversion, and substitute (sections 4 and 5)."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

from tests.adapter.reference.values.number_format import Number, NumberFormat
from tests.adapter.reference.values.value import Numbers


@dataclass(frozen=True)
class Element:
    """One number of a value."""

    source: NumberFormat
    target: NumberFormat
    factor: Fraction = Fraction(1)
    offset: Fraction = Fraction(0)
    """The number in the target = that in the source × factor + offset."""
    names: Mapping[int, int] | None = None
    """Numbers of the target by numbers of the source, for an enumeration."""
    least: Fraction | None = None
    """Smallest number of the source that is within the limits."""
    greatest: Fraction | None = None
    is_checked: bool = False
    init: Number = 0
    """In the target, as is the default."""
    default: Number = 0

    def is_outside(self, number: Number) -> bool:
        """Whether a number of the source is outside of its limits."""
        if self.names is not None:
            return number not in self.names
        if not self.is_checked:
            return False
        if not math.isfinite(number):
            return True
        is_low = self.least is not None and number < self.least
        return is_low or (self.greatest is not None and number > self.greatest)

    def convert(self, number: Number) -> Number:
        """A number of the source, in the target."""
        if self.names is not None:
            return self.names[int(number)]
        if self.source == self.target and self.factor == 1 and self.offset == 0:
            return number
        return self.target.cast(self._scaled(number), self.default)

    def _scaled(self, number: Number) -> Number:
        if self.factor != 1:
            number = float(number) * float(self.factor)
        return float(number) + float(self.offset) if self.offset != 0 else number


class Taken(NamedTuple):
    """Result of the transfer of a value."""

    numbers: Numbers
    is_outside: bool


@dataclass(frozen=True)
class Transfer:
    """A value on its way: from what is received to a variable, or from a variable to what is sent."""

    elements: tuple[Element, ...]
    is_single: bool
    """Whether it is a number, and neither array nor struct."""
    action: str | None = None
    """Replacement of a value outside its limits: Default or Init."""

    @property
    def init(self) -> Numbers:
        """The start value."""
        return tuple(element.init for element in self.elements)

    @property
    def default(self) -> Numbers:
        """Return the substitute of a missing value."""
        return tuple(element.default for element in self.elements)

    def take(self, numbers: Numbers, before: Numbers) -> Taken:
        """Return the result for numbers of the source. `before` is the previous value."""
        pairs = list(zip(self.elements, numbers, strict=True))
        if not any(element.is_outside(number) for element, number in pairs):
            return Taken(tuple(element.convert(number) for element, number in pairs), is_outside=False)
        if self.action is not None:
            return Taken(self.default if self.action == "Default" else self.init, is_outside=True)
        is_unnamed = any(element.names is not None and element.is_outside(number) for element, number in pairs)
        passed = before if is_unnamed else tuple(element.convert(number) for element, number in pairs)
        return Taken(passed, is_outside=True)
