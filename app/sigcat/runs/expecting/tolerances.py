"""Accepted differences of outputs from expected ones."""

import math
from collections.abc import Collection, Mapping, Sequence
from typing import NamedTuple

from sigcat.errors import UsageError
from sigcat.names import did_you_mean


class Tolerance(NamedTuple):
    """A difference that is accepted: the larger one of a number and a share of the expected value."""

    absolute: float = 0.0
    relative: float = 0.0

    def accepts(self, expected: float, actual: float) -> bool:
        """Whether a value is near enough. NaN is NaN."""
        if expected == actual or (math.isnan(expected) and math.isnan(actual)):
            return True
        return abs(actual - expected) <= max(self.absolute, self.relative * abs(expected)) < math.inf


class Tolerances(NamedTuple):
    """Tolerance of all signals, and those of single ones."""

    general: Tolerance
    by_name: Mapping[str, Tolerance]

    def of(self, names: Collection[str]) -> Tolerance:
        """Return the tolerance of a signal with these names."""
        return next((self.by_name[name] for name in names if name in self.by_name), self.general)


def tolerances(texts: Sequence[str], names: Collection[str]) -> Tolerances:
    """Tolerances of options such as `0.01`, `1%` and `Vehicle.Speed=0.1`. Raises UsageError."""
    general, by_name = Tolerance(), dict[str, Tolerance]()
    for text in texts:
        name, is_named, number = text.rpartition("=")
        if is_named and name not in names:
            raise UsageError(f"the run does not send {name!r}. {did_you_mean(name, names)}".rstrip(". "))
        if is_named:
            by_name[name] = _tolerance(number, text)
        else:
            general = _tolerance(number, text)
    return Tolerances(general, by_name)


def _tolerance(number: str, text: str) -> Tolerance:
    try:
        value = float(number.removesuffix("%"))
    except ValueError:
        value = math.nan
    if not 0 <= value < math.inf:
        raise UsageError(f"--tolerance must be a number from 0 on, a share such as 1%, or NAME=NUMBER, not {text!r}")
    return Tolerance(0.0, value / 100) if number.endswith("%") else Tolerance(value)
