"""Times of a document, in whole nanoseconds."""

import re
from fractions import Fraction

from tests.adapter.reference.reading.scale import JsonNumber, exact

_TEXT = re.compile(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*(us|µs|ms|s|)\s*", re.IGNORECASE)
_UNITS = {"us": 1000, "µs": 1000, "ms": 10**6, "": 10**6, "s": 10**9}


def nanoseconds(given: str | JsonNumber | None) -> int | None:
    """A time in ms, or a text with its unit; None if there is none."""
    if isinstance(given, str):
        match = _TEXT.fullmatch(given)
        return _whole(Fraction(match[1]) * _UNITS[match[2].lower()]) if match else None
    number = exact(given)
    return None if number is None else _whole(number * 10**6)


def _whole(number: Fraction) -> int:
    if number.denominator != 1:
        raise ValueError(f"A time must be whole nanoseconds, not {float(number)}.")
    return int(number)
