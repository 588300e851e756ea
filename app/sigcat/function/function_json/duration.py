"""Durations, which the wire format writes as texts, or as whole milliseconds with nanoseconds where these are not enough."""

import math
import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sigcat.function.document.structure import unfit
from sigcat.function.function_json.conversion import is_finite_number

_DURATION = re.compile(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*(us|µs|ms|s|)\s*", re.IGNORECASE)
_MILLISECONDS = {"": 1.0, "ms": 1.0, "s": 1000.0, "us": 0.001, "µs": 0.001}


def milliseconds(text: str | None) -> float | None:
    """The duration that a text of the wire format means, in ms: `100`, `100 ms`, `0.1 s`; None if it means none."""
    match = _DURATION.fullmatch(text) if text else None
    return float(match[1]) * _MILLISECONDS[match[2].lower()] if match else None


NANOSECONDS = 10**6
"""In a millisecond."""
LONGEST_MILLISECONDS = 10**12
"""Some thirty years, so that sums of times do not overflow."""


def time_in_a_name(time: float) -> str:
    """A time in ms without a point, in the largest unit that has it whole: 10 → `10ms`, 2.5 → `2500us`, 0.0625 → `62500ns`."""
    exact = Fraction(repr(time))
    unit, number = next(
        (unit, exact * factor)
        for unit, factor in _IN_A_NAME.items()
        if (exact * factor).denominator == 1 or unit == "ns"
    )
    return f"{round(number)}{unit}"


_IN_A_NAME = {"ms": 1, "us": 1000, "ns": NANOSECONDS}


def whole_nanoseconds(time: float) -> int | None:
    """A time in ms as nanoseconds; None where these are not whole."""
    exact = Fraction(repr(time)) * NANOSECONDS
    return int(exact) if exact.denominator == 1 else None


def exact_time(data: Any, field: str, key: str) -> Any:
    """A part of Function JSON with a time in ms that is exact, `key`, and in ns where it is not whole milliseconds, `keyNanoseconds`.

    `field` is the name of the time in Python, that of the nanoseconds has `_nanoseconds` behind it.
    """
    if not isinstance(data, Mapping):
        return data
    exact, time = data.get(f"{key}Nanoseconds", data.get(f"{field}_nanoseconds")), data.get(key, data.get(field))
    others = {name: value for name, value in data.items() if name not in (field, f"{field}_nanoseconds")}
    if is_finite_number(exact):
        milliseconds = _plain(exact / NANOSECONDS)
        if time not in (None, milliseconds, math.ceil(milliseconds)):
            raise unfit(f"`{key}` must be the time of `{key}Nanoseconds`, {milliseconds:g} ms, or absent.", key)
        return {**others, key: milliseconds}
    if not is_finite_number(time):
        return data
    rest = {} if time == int(time) else {f"{key}Nanoseconds": whole_nanoseconds(time)}
    return {**others, key: _plain(time), **rest}


def _plain(number: float) -> float | int:
    return int(number) if number == int(number) else number


def whole(number: float | None) -> float | None:
    """A number that is whole as an integer, so that it is written as one."""
    return int(number) if number is not None and number == int(number) else number
