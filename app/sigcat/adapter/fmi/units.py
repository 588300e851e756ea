"""Units of variables in SI units, as FMI and SSP describe them."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.integration.autosar_si_units import Dimension, si_unit

_SYMBOLS = dict(zip(Dimension._fields, ("m", "kg", "s", "A", "K", "mol", "cd"), strict=True))


class FmiUnit(NamedTuple):
    """A unit by its key in the catalogue: `value in SI units = value × factor + offset`."""

    name: str
    exponents: tuple[tuple[str, int], ...] | None = None
    """Exponents of SI units by their symbols; None without a linear way to SI units."""
    factor: float = 1.0
    offset: float = 0.0


def fmi_units(names: Iterable[str]) -> tuple[FmiUnit, ...]:
    """Return each unit once."""
    return tuple(map(_fmi_unit, dict.fromkeys(names)))


def _fmi_unit(name: str) -> FmiUnit:
    known = si_unit(name)
    if known is None:
        return FmiUnit(name)
    exponents = tuple((_SYMBOLS[base], number) for base, number in known.dimension._asdict().items() if number)
    to_si = known.from_si.inverse
    return FmiUnit(name, exponents, float(to_si.factor), float(to_si.offset))
