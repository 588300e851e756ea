"""Numbers between YAML, exact fractions and the texts of Function JSON."""

import sys
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from typing import Any

from sigcat.function.function_json.conversion import as_number


@lru_cache(maxsize=4096, typed=True)
def fraction(value: Any) -> Fraction:
    """A number as it was written: 0.1 is a tenth, not the nearest double."""
    return Fraction(repr(value))


def optional_number(value: Fraction | None) -> float | None:
    """A fraction as a number of Function JSON."""
    return None if value is None else as_number(value)


def plain_text(number: float | None) -> str | None:
    """A number as a text of Function JSON: 200.0 → `200`."""
    return None if number is None else str(int(number)) if number == int(number) else f"{Decimal(repr(number)):f}"


def shown(value: Fraction) -> str:
    """A fraction in a message; it may be larger than any double, as the largest one in another unit is."""
    if abs(value) > Fraction(sys.float_info.max):
        return f"{Decimal(value.numerator) / value.denominator:.4g}"
    if value.denominator != 1:
        return f"{as_number(value):.12g}"
    return str(value.numerator) if abs(value) < 10**21 else f"{float(value):.4g}"
