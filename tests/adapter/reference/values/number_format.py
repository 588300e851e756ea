"""Formats of numbers in C: what each holds, and how a number is brought to it."""

import math
from fractions import Fraction
from typing import NamedTuple

from sigcat.catalogue.model.datatypes import FLOATING, INTEGER_RANGES

Number = int | float
"""A number of C: a float has the value of a `float` or a `double`, an int that of an integer or a boolean."""


class NumberFormat(NamedTuple):
    """A primitive datatype, by its name in VSS."""

    name: str

    @property
    def is_boolean(self) -> bool:
        """Whether it holds true and false."""
        return self.name == "boolean"

    @property
    def is_floating(self) -> bool:
        """Whether it holds fractions."""
        return self.name in FLOATING

    @property
    def is_wide(self) -> bool:
        """Whether it holds integers that a double does not."""
        return self.name in ("uint64", "int64")

    @property
    def ends(self) -> tuple[Fraction, Fraction]:
        """The smallest and the largest number that it holds."""
        if self.is_floating:
            largest = _LARGEST[self.name]
            return -largest, largest
        low, high = INTEGER_RANGES.get(self.name, (0, 1))
        return Fraction(low), Fraction(high)

    def nearest(self, exact: Fraction) -> Number:
        """The number next to an exact one, ties to even, saturated."""
        if self.is_boolean:
            return int(exact != 0)
        low, high = self.ends
        within = min(max(exact, low), high)
        return float(_floating(within, *_FORMATS[self.name])) if self.is_floating else round(within)

    def cast(self, value: Number, not_a_number: Number) -> Number:
        """A number of another format, brought to this one. An integer has `not_a_number` for NaN."""
        if self.is_boolean:
            return int(value != 0)
        if not math.isfinite(value):
            return value if self.is_floating else self._infinite(value, not_a_number)
        nearest = self.nearest(Fraction(value))
        return math.copysign(nearest, value) if self.is_floating else nearest

    def _infinite(self, value: float, not_a_number: Number) -> Number:
        low, high = self.ends
        return not_a_number if math.isnan(value) else round(high if value > 0 else low)


_FORMATS = {"float": (24, -149), "double": (53, -1074)}
"""Binary digits, and the exponent of the smallest number."""
_LARGEST = {"float": Fraction((2**24 - 1) * 2**104), "double": Fraction((2**53 - 1) * 2**971)}


def _floating(number: Fraction, digits: int, least: int) -> Fraction:
    """The binary number of so many digits that is next to a number."""
    if number == 0:
        return number
    exponent = abs(number.numerator).bit_length() - number.denominator.bit_length()
    if abs(number) < Fraction(2) ** exponent:
        exponent -= 1
    unit = Fraction(2) ** max(exponent - digits + 1, least)
    return round(number / unit) * unit
