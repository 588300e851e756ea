"""Conversion between units and between stored and physical values: exact, as fractions.

The factors are those of ISO 80000 and of the definitions of the units; only the ratio of radian to degree is not
rational, and is taken so near that both directions have the nearest double.
"""

import math
import re
import sys
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple


class Linear(NamedTuple):
    """`result = value × factor + offset`."""

    factor: Fraction = Fraction(1)
    offset: Fraction = Fraction(0)

    def __call__(self, value: float | Fraction) -> Fraction:
        """The value, converted."""
        return Fraction(value) * self.factor + self.offset

    @property
    def inverse(self) -> "Linear":
        """The conversion back."""
        return Linear(1 / self.factor, -self.offset / self.factor)

    def then(self, other: "Linear") -> "Linear":
        """This conversion, and the other one after it."""
        return Linear(self.factor * other.factor, self.offset * other.factor + other.offset)


IDENTITY = Linear()

_PI = Fraction("3.14159265358979323846264338327950288419716939937510")
_RADIAN = (180 / _PI).limit_denominator(10**10)
_TO_BASE: dict[str, dict[str, Linear]] = {
    "length": {
        "mm": Linear(Fraction(1, 1000)), "cm": Linear(Fraction(1, 100)), "m": IDENTITY,
        "km": Linear(Fraction(1000)), "inch": Linear(Fraction(254, 10000)),
    },
    "velocity": {"km/h": Linear(Fraction(5, 18)), "m/s": IDENTITY},
    "acceleration": {"m/s^2": IDENTITY, "cm/s^2": Linear(Fraction(1, 100))},
    "volume": {"ml": Linear(Fraction(1, 1000)), "cm^3": Linear(Fraction(1, 1000)), "l": IDENTITY},
    "temperature": {
        "celsius": IDENTITY, "fahrenheit": Linear(Fraction(5, 9), Fraction(-160, 9)),
    },
    "angle": {"degrees": IDENTITY, "radians": Linear(_RADIAN)},
    "angular speed": {"degrees/s": IDENTITY, "rad/s": Linear(_RADIAN), "rpm": Linear(Fraction(6))},
    "power": {"w": IDENTITY, "kw": Linear(Fraction(1000)), "ps": Linear(Fraction("735.49875"))},
    "mass": {"g": Linear(Fraction(1, 1000)), "kg": IDENTITY, "lbs": Linear(Fraction("0.45359237"))},
    "duration": {
        "ms": Linear(Fraction(1, 1000)), "s": IDENTITY, "min": Linear(Fraction(60)), "h": Linear(Fraction(3600)),
        "day": Linear(Fraction(86400)), "weeks": Linear(Fraction(604800)),
    },
    "pressure": {
        "pa": IDENTITY, "mbar": Linear(Fraction(100)), "kpa": Linear(Fraction(1000)), "bar": Linear(Fraction(100000)),
        "psi": Linear(Fraction("4.4482216152605") / Fraction("0.00064516")),
    },
    "energy per distance": {"kwh/100km": Linear(Fraction(10)), "wh/km": IDENTITY},
    "volume per distance": {"ml/100km": Linear(Fraction(1, 1000)), "l/100km": IDENTITY},
    "force": {"n": IDENTITY, "kn": Linear(Fraction(1000))},
    "relation": {"ratio": IDENTITY, "percent": Linear(Fraction(1, 100))},
}  # fmt: skip


@lru_cache(maxsize=4096)
def between(source: str, target: str) -> Linear | None:
    """From values in one unit to values in another, by their keys; None without a linear conversion."""
    source, target = source.lower(), target.lower()
    if source == target:
        return IDENTITY
    units = _kind_of(source)
    return units[source].then(units[target].inverse) if target in units else None


def _kind_of(key: str) -> dict[str, Linear]:
    """The units that one converts to, with their factors, by their keys."""
    return next((units for units in _TO_BASE.values() if key in units), {})


def base_of(unit: str) -> str | None:
    """Key of the unit that factors of this kind lead to; None if there are none."""
    return next((key for key, linear in _kind_of(unit.lower()).items() if linear == IDENTITY), None)


def same_kind(unit: str) -> tuple[str, ...]:
    """Keys of the units that `unit` can be converted to, itself left out."""
    return tuple(each for each in _kind_of(unit.lower()) if each != unit.lower())


@lru_cache(maxsize=4096)
def as_text(number: Fraction) -> str:
    """A number, exactly: decimal where that has an end, else a fraction, `5/18`."""
    return as_decimal(number) if _has_end(number) else f"{number.numerator}/{number.denominator}"


def as_decimal(number: Fraction) -> str:
    """A decimal number for code: exact where it has an end, else the nearest double."""
    if number.denominator == 1 or abs(number) > _LARGEST:
        return str(round(number))
    value = repr(float(number))
    return value if not _has_end(number) or Fraction(value) == number else _exact(number)


def _has_end(number: Fraction) -> bool:
    """Whether a decimal number has an end."""
    rest = number.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest == 1


_NUMBER = re.compile(
    r"[+-]?(?:[0-9]{1,400}(?:\.[0-9]{0,400})?|\.[0-9]{1,400})(?:[eE][+-]?[0-9]{1,3})?|[+-]?[0-9]{1,40}/0*[1-9][0-9]{0,39}"
)
"""A number, of a size that exact arithmetic bears."""
_LARGEST = Fraction(sys.float_info.max)


@lru_cache(maxsize=4096)
def of_text(text: str) -> Fraction | None:
    """The number that a document has as text, decimal or a fraction; None if it is none, or larger than a double."""
    number = Fraction(text.strip()) if _NUMBER.fullmatch(text.strip()) else None
    if number is None or abs(number) > _LARGEST:
        return None
    return number if abs(number) * _LARGEST >= 1 else Fraction(0)


def is_finite_number(value: Any) -> bool:
    """Whether this is a number of YAML or JSON that is finite, and not true or false."""
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def is_outside(number: float | Fraction, low: float | Fraction | None, high: float | Fraction | None) -> bool:
    """Whether a number lies outside a range that may be open."""
    return (low is not None and number < low) or (high is not None and number > high)


def as_written(value: object) -> Fraction | None:
    """A number of YAML or JSON as it is written, 0.1 as a tenth, and true as 1; None if it is not finite."""
    if isinstance(value, bool):
        return Fraction(int(value))
    try:
        return Fraction(repr(value)) if isinstance(value, int | float) else None
    except ValueError:  # not a finite number
        return None


def as_number(number: Fraction) -> float:
    """A number for the wire: a whole one stays whole."""
    return number.numerator if number.denominator == 1 else float(number)


def _exact(number: Fraction) -> str:
    digits = 0
    while (number * 10**digits).denominator != 1:
        digits += 1
    sign = "-" if number < 0 else ""
    text = str(abs(number * 10**digits)).rjust(digits + 1, "0")
    return f"{sign}{text[:-digits]}.{text[-digits:]}"
