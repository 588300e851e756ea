"""Number types of C, and exact numbers brought to them (docs/reference/adapter.md, sections 4 and 5)."""

import math
import struct
from fractions import Fraction
from functools import lru_cache
from typing import NamedTuple

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.function_json.datatypes.primitive_types import (
    BY_VSS,
    LARGEST_DOUBLE,
    LARGEST_FLOAT,
    c_type,
)


class NumberType(NamedTuple):
    """A type that holds one number."""

    name: str
    """Its name in VSS: `uint8`, `float`, `boolean`."""
    c: str
    """Its name in C."""

    @property
    def is_integer(self) -> bool:
        """Whether it holds whole numbers only; a boolean is none of them."""
        return self.name in INTEGER_RANGES

    @property
    def is_floating(self) -> bool:
        """Whether it is a float or a double."""
        return self.name in ("float", "double")

    @property
    def is_boolean(self) -> bool:
        """Whether it holds true and false."""
        return self.name == "boolean"

    @property
    def is_wide(self) -> bool:
        """Whether it holds whole numbers that a double does not."""
        return self.name in ("uint64", "int64")

    @property
    def smallest(self) -> Fraction:
        """Smallest number that it holds."""
        return -self.largest if self.is_floating else Fraction(INTEGER_RANGES.get(self.name, (0, 1))[0])

    @property
    def largest(self) -> Fraction:
        """Largest number that it holds."""
        if self.is_floating:
            return Fraction(LARGEST_FLOAT if self.name == "float" else LARGEST_DOUBLE)
        return Fraction(INTEGER_RANGES.get(self.name, (0, 1))[1])


DOUBLE, FLOAT = NumberType("double", "double"), NumberType("float", "float")


def number_type(vss: str) -> NumberType | None:
    """The type of a VSS datatype; None if it holds no number."""
    row = BY_VSS.get(vss)
    return NumberType(row.vss, row.c) if row and vss != "string" else None


def type_of_c(definition: str) -> NumberType | None:
    """The type of a C definition; None if it holds no number, or none of a fixed width."""
    meant = c_type(definition)
    if meant is None or meant.kind == "text" or meant.bits == 0:
        return None
    if meant.kind == "boolean":
        return number_type("boolean")
    if meant.kind == "floating":
        return number_type("float" if meant.bits == 32 else "double")
    return number_type(f"{'u' if meant.kind == 'unsigned' else ''}int{meant.bits}")


Number = int | float
"""A number of C, as Python has it."""


@lru_cache(maxsize=4096)
def brought_to(number: Fraction, wanted: NumberType) -> Number:
    """A number as a type holds it: rounded once, ties to even, and saturated."""
    if wanted.is_boolean:
        return int(number != 0)
    number = min(max(number, wanted.smallest), wanted.largest)
    if wanted.is_integer:
        return round(number)
    return nearest_float(number) if wanted.name == "float" else float(number)


def nearest_float(number: Fraction) -> float:
    """The nearest number of binary32, ties to even, in one rounding."""
    near = float(struct.unpack("f", struct.pack("f", float(number)))[0])
    if near == number:
        return near
    candidates = [near, *(_next_float(near, step) for step in (-1, 1))]
    return float(min(candidates, key=lambda each: (abs(Fraction(each) - number), _bits(each) & 1)))


def _bits(number: float) -> int:
    return int(struct.unpack("I", struct.pack("f", number))[0])


def _next_float(number: float, step: int) -> float:
    if number == 0:
        return step * float(struct.unpack("f", struct.pack("I", 1))[0])
    bits = _bits(number) + (step if number > 0 else -step)
    near = float(struct.unpack("f", struct.pack("I", bits))[0])
    return near if math.isfinite(near) else number


def least_limit(limit: Fraction, source: NumberType) -> Number | None:
    """A smallest value on the scale of a source: of a float the nearest, of an integer the one within; None if the
    source holds nothing that is smaller."""
    if source.is_floating:
        return brought_to(limit, source)
    return math.ceil(limit) if limit > source.smallest else None


def greatest_limit(limit: Fraction, source: NumberType) -> Number | None:
    """A largest value on the scale of a source, as `least_limit`."""
    if source.is_floating:
        return brought_to(limit, source)
    return math.floor(limit) if limit < source.largest else None
