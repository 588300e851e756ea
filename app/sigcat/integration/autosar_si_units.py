"""The units of VSS in SI units: their dimension, and the exact way from a value in SI units to one in the unit."""

from fractions import Fraction
from typing import NamedTuple, Self

from pydantic import Field, model_validator

from sigcat.function.declaration.form import DeclarationModel
from sigcat.function.document.structure import unfit
from sigcat.function.function_json.conversion import IDENTITY, Linear, between, same_kind
from sigcat.function.function_json.wire import Integer, Number


class Dimension(NamedTuple):
    """Exponents of the base quantities of the SI."""

    length: int = 0
    mass: int = 0
    time: int = 0
    current: int = 0
    temperature: int = 0
    molar_amount: int = 0
    luminous_intensity: int = 0


class SiUnit(NamedTuple):
    """A unit in SI units."""

    dimension: Dimension
    from_si: Linear


class UnitSettings(DeclarationModel):
    """A unit that is not one of VSS, in SI units."""

    factor: Number = Field(description="Value in the unit = value in SI units × factor + offset; 3.6 for km/h.")
    offset: Number = Field(0, description="Offset of that, in the unit; -273.15 for degrees Celsius.")
    length: Integer = Field(0, description="Exponent of the metre.")
    mass: Integer = Field(0, description="Exponent of the kilogram.")
    time: Integer = Field(0, description="Exponent of the second.")
    current: Integer = Field(0, description="Exponent of the ampere.")
    temperature: Integer = Field(0, description="Exponent of the kelvin.")
    molar_amount: Integer = Field(0, description="Exponent of the mole.")
    luminous_intensity: Integer = Field(0, description="Exponent of the candela.")

    @model_validator(mode="after")
    def _has_a_way_back(self) -> Self:
        if not self.factor:
            raise unfit("`factor` must not be 0.", "factor")
        return self

    @property
    def si(self) -> SiUnit:
        """The unit in SI units."""
        dimension = Dimension(*(getattr(self, quantity) for quantity in Dimension._fields))
        return SiUnit(dimension, Linear(_exact(self.factor), _exact(self.offset)))


def _exact(number: float) -> Fraction:
    """The decimal number that was written, not the double that it was read as."""
    return Fraction(str(number))


def _unit(dimension: Dimension, to_si: Linear | Fraction | int = 1) -> SiUnit:
    way = to_si if isinstance(to_si, Linear) else Linear(Fraction(to_si))
    return SiUnit(dimension, way.inverse)


_ENERGY = Dimension(length=2, mass=1, time=-2)
_MILE = Fraction("1609.344")
_OF_A_KIND = {
    "m": _unit(Dimension(length=1)), "m/s": _unit(Dimension(length=1, time=-1)),
    "m/s^2": _unit(Dimension(length=1, time=-2)), "l": _unit(Dimension(length=3), Fraction(1, 1000)),
    "celsius": _unit(Dimension(temperature=1), Linear(Fraction(1), Fraction("273.15"))), "radians": _unit(Dimension()),
    "rad/s": _unit(Dimension(time=-1)), "w": _unit(Dimension(length=2, mass=1, time=-3)), "kg": _unit(Dimension(mass=1)),
    "s": _unit(Dimension(time=1)), "pa": _unit(Dimension(length=-1, mass=1, time=-2)),
    "wh/km": _unit(Dimension(length=1, mass=1, time=-2), Fraction("3.6")),
    "l/100km": _unit(Dimension(length=2), Fraction(1, 10**8)), "n": _unit(Dimension(length=1, mass=1, time=-2)),
    "ratio": _unit(Dimension()),
}  # fmt: skip
"""One unit of each kind that functions convert between."""
_OTHERS = {
    "us": _unit(Dimension(time=1), Fraction(1, 10**6)), "ns": _unit(Dimension(time=1), Fraction(1, 10**9)),
    "hPa": _unit(Dimension(length=-1, mass=1, time=-2), 100), "kWh": _unit(_ENERGY, 3_600_000), "Nm": _unit(_ENERGY),
    "V": _unit(Dimension(length=2, mass=1, time=-3, current=-1)), "A": _unit(Dimension(current=1)),
    "Ah": _unit(Dimension(time=1, current=1), 3600), "Ohm": _unit(Dimension(length=2, mass=1, time=-3, current=-2)),
    "g/s": _unit(Dimension(mass=1, time=-1), Fraction(1, 1000)),
    "g/km": _unit(Dimension(length=-1, mass=1), Fraction(1, 10**6)),
    "l/h": _unit(Dimension(length=3, time=-1), Fraction(1, 3_600_000)),
    "km/l": _unit(Dimension(length=-2), 10**6), "mpg": _unit(Dimension(length=-2), _MILE / Fraction("0.003785411784")),
    "mpg-us": _unit(Dimension(length=-2), _MILE / Fraction("0.003785411784")),
    "mpg-uk": _unit(Dimension(length=-2), _MILE / Fraction("0.00454609")),
    "mm/h": _unit(Dimension(length=1, time=-1), Fraction(1, 3_600_000)), "Hz": _unit(Dimension(time=-1)),
    "cpm": _unit(Dimension(time=-1), Fraction(1, 60)), "bpm": _unit(Dimension(time=-1), Fraction(1, 60)),
    "nm/km": _unit(Dimension(), Fraction(1, 10**12)), "lx": _unit(Dimension(length=-2, luminous_intensity=1)),
}  # fmt: skip
WITHOUT_SI = frozenset({"stars", "dB", "dBm", "unix-time", "iso8601", "months", "years", "mpge"})
"""Units of VSS that no factor leads to: a scale, a logarithm, a date, or a time that is not always as long."""


def si_unit(unit: str) -> SiUnit | None:
    """A unit of VSS by its key; None if it is another one, or has no linear way to SI units."""
    if unit in _OTHERS:
        return _OTHERS[unit]
    for key, known in _OF_A_KIND.items():
        if unit.lower() == key or unit.lower() in same_kind(key):
            return SiUnit(known.dimension, known.from_si.then(between(key, unit) or IDENTITY))
    return None
