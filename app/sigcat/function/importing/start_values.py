"""The values that parameters have in the code from the start, as physical values."""

import struct
from fractions import Fraction
from math import isfinite
from typing import Any

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.c_project.code_values import Value


def factor_of(value: Value) -> float | int | None:
    """The factor of an integer that is scaled or has an offset; None of any other value."""
    factor, is_moved = value.remark.factor, bool(value.remark.offset)
    if value.datatype in ("float", "double", "boolean") or factor == 0 or (factor in (None, 1) and not is_moved):
        return None
    return factor or 1


def stored_range(value: Value) -> tuple[float, float]:
    """The range of physical values that the variable holds."""
    ends = [_scaled(end, value) for end in stored_ends(value)]
    return min(ends), max(ends)


def stored_ends(value: Value) -> tuple[int, int]:
    """The smallest and the largest number that an integer variable holds."""
    least, most = INTEGER_RANGES[value.datatype]
    if not value.bits:
        return least, most
    return (-(1 << value.bits - 1), (1 << value.bits - 1) - 1) if least else (0, (1 << value.bits) - 1)


def _scaled(stored: int, value: Value) -> float:
    factor, offset = Fraction(repr(factor_of(value) or 1)), Fraction(repr(value.remark.offset or 0))
    return float(factor * stored + offset)


def start_of(value: Value) -> Any:
    """The value at start-up; 0 where the code has none, or has one that depends on others."""
    if not value.length:
        return _physical(value.start, value)
    start = value.start[: value.length] if isinstance(value.start, list) else []
    rest = [0] * (value.length - len(start))  # C sets to 0 what an initializer leaves out
    return [_physical(each, value) for each in (*start, *rest)]


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
