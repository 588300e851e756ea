"""Limits that a CAN database states for a signal, which is one of cantools, and numbers as they are transmitted."""

import math
from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.network.network_values import NetworkValue

_ROUNDING = 1e-14
"""Largest relative error of a product and a sum of doubles against the decimal that they mean."""


def within(number: float, least: float | None, greatest: float | None, step: float) -> float | None:
    """A number that is within limits; None if it is outside.

    Limits are written in decimals, and numbers come in steps: a number beyond a limit by less than half a step is the step
    that was meant, and a number that only the rounding of a double brought beyond it is the limit. NaN is within.
    """
    if least is not None and number < least:
        limit = least
    elif greatest is not None and number > greatest:
        limit = greatest
    else:
        return number
    if isinstance(number, float) and math.isclose(number, limit, rel_tol=_ROUNDING):
        return limit
    return number if abs(number - limit) < step / 2 else None


def physical(signal: Any, raw: float) -> float:
    """A transmitted number in the unit of its signal: whole where factor and offset are, of 64 bits too."""
    found: float = signal.conversion.raw_to_scaled(raw, decode_choices=False)
    return found


def step(signal: Any) -> float:
    """From one number of a signal to the next, in its unit; 0 for floats."""
    return 0.0 if signal.conversion.is_float else abs(float(signal.conversion.scale))


def limited(signal: Any, number: float) -> float | None:
    """A number in the unit of a signal, within its limits; None if it is outside."""
    return within(number, signal.minimum, signal.maximum, step(signal))


def network_value(signal: Any, raw: float, known: Mapping[int, str]) -> NetworkValue | None:
    """The value of a transmitted number; None if it is outside of the limits and has no name among the known ones."""
    found = physical(signal, raw)
    number = limited(signal, found)
    name = known.get(raw)  # type: ignore[call-overload]  # a float has a name too
    if number is None and name is None:
        return None
    return NetworkValue(raw, found if number is None else number, name, number is not None)


def names(signal: Any) -> dict[int, str]:
    """Names of transmitted numbers."""
    return {int(number): str(name) for number, name in (signal.conversion.choices or {}).items()}
