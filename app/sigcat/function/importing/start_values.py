"""The values that parameters have in the code from the start, as physical values."""

import struct
from fractions import Fraction
from math import isfinite
from typing import Any

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.c_project.values import Value


def factor_of(value: Value) -> float | int | None:
    is_integer = value.datatype not in ("float", "double", "boolean")
    return value.remark.factor if is_integer and value.remark.factor not in (0, 1) else None


def stored_range(value: Value) -> tuple[float, float]:
    """The range of physical values that the datatype of the code holds."""
    ends = [_scaled(end, value) for end in INTEGER_RANGES[value.datatype]]
    return min(ends), max(ends)


def _scaled(stored: int, value: Value) -> float:
    factor, offset = Fraction(repr(value.remark.factor)), Fraction(repr(value.remark.offset or 0))
    return float(factor * stored + offset)


def start_of(value: Value) -> Any:
    """The value at start-up; 0 where the code has none, or has one that depends on others."""
    if not value.length:
        return _physical(value.start, value)
    start = value.start if isinstance(value.start, list) else []
    return [_physical(each, value) for each in _filled(start, value.length)]


def _filled(start: list[Any], count: int) -> list[Any]:
    """C sets to 0 what an initializer leaves out."""
    return [*start[:count], *([0] * (count - len(start)))]


def _physical(start: Any, value: Value) -> Any:
    stored = start if isinstance(start, int | float) and isfinite(start) else 0
    if value.datatype == "boolean":
        return bool(stored)
    if value.datatype in ("float", "double"):
        return _shortest(float(stored)) if value.datatype == "float" else float(stored)
    return int(stored) if factor_of(value) is None else _scaled(int(stored), value)


def _shortest(value: float) -> float:
    """The shortest number that a C float holds as the same value: 0.1 of 0.10000000149."""
    for digits in range(6, 10):
        candidate = float(f"{value:.{digits}g}")
        if _stored(candidate) == _stored(value):
            return candidate
    return value


def _stored(value: float) -> bytes:
    try:
        return struct.pack("f", value)
    except OverflowError:
        return b""
