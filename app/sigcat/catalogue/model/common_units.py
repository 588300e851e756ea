"""Common units that VSS does not define, and other names of its quantities."""

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from sigcat.names import did_you_mean

_OUTSIDE_VSS: Mapping[str, str] = {
    "temperature": "K kelvin",
    "relation": "ppm parts per million, ppb parts per billion, permille parts per thousand",
    "electric-current": "mA milliampere, uA microampere, kA kiloampere",
    "electric-charge": "mAh milliampere hours, As ampere seconds",
    "voltage": "mV millivolt, kV kilovolt",
    "power": "mW milliwatt, MW megawatt, hp mechanical horsepower, VA volt ampere",
    "work": "J joule, kJ kilojoule, MJ megajoule, Wh watt hours",
    "pressure": "bar bar, MPa megapascal, atm standard atmosphere, mmHg millimeter of mercury",
    "angle": "rad radian, arcmin minute of arc, arcsec second of arc, mrad milliradian",
    "frequency": "kHz kilohertz, MHz megahertz, GHz gigahertz",
    "duration": "us microsecond, ns nanosecond",
    "velocity": "mph miles per hour, cm/s centimeters per second, kt knot",
    "length": "mi mile, ft foot, yd yard, um micrometer, dm decimeter",
    "mass": "mg milligram, t tonne, ug microgram",
    "volume": "m3 cubic meter, gal gallon, dl deciliter",
    "volume-flow-rate": "l/min liters per minute, m3/h cubic meters per hour, l/s liters per second",
    "mass-per-time": "kg/h kilograms per hour, kg/s kilograms per second",
    "mass-per-distance": "mg/km milligrams per kilometer",
    "resistance": "mOhm milliohm, kOhm kiloohm, MOhm megaohm",
    "torque": "kNm kilonewton meter",
    "rotational-speed": "rps revolutions per second",
    "mass-per-volume": "ug/m3 micrograms per cubic meter, mg/m3 milligrams per cubic meter, "
    "kg/m3 kilograms per cubic meter, g/l grams per liter",
    "irradiance": "W/m2 watts per square meter",
    "luminous-intensity": "cd candela",
    "area": "m2 square meter, cm2 square centimeter, mm2 square millimeter",
    "data-rate": "kbit/s kilobits per second, Mbit/s megabits per second",
    "angular-acceleration": "deg/s2 degrees per second squared, rad/s2 radians per second squared",
    "capacitance": "F farad",
    "magnetic-flux-density": "T tesla",
}
"""Common units that VSS does not define, by quantity: code and name of each."""
_QUANTITIES: Mapping[str, str] = {
    "work": "energy heat",
    "velocity": "speed",
    "duration": "time time-span",
    "datetime": "date timestamp time-stamp",
    "length": "distance height width depth",
    "mass": "weight",
    "temperature": "thermodynamic-temperature",
    "angle": "plane-angle",
    "angular-speed": "angular-velocity",
    "rotational-speed": "rotational-velocity rotational-frequency rotation-speed",
    "torque": "moment moment-of-force",
    "voltage": "electric-potential potential-difference",
    "electric-current": "current",
    "electric-charge": "charge",
    "resistance": "electric-resistance",
    "relation": "ratio fraction percentage concentration dimensionless dimensionless-ratio",
    "volume-flow-rate": "flow flow-rate volume-flow volumetric-flow volumetric-flow-rate",
    "mass-per-time": "mass-flow mass-flow-rate",
    "volume-per-distance": "fuel-consumption",
    "distance-per-volume": "fuel-economy",
}
"""Other names of quantities of VSS, several in one text."""
_SIGNS = str.maketrans({"µ": "u", "μ": "u", "²": "2", "³": "3", "·": None, "^": None, "_": None, " ": None, "°": "deg"})


class CommonUnit(NamedTuple):
    """A unit that VSS does not define."""

    key: str
    name: str
    quantity: str


def common_unit(name: str) -> CommonUnit | None:
    """Return the unit outside VSS that a spelling means, also in the plural."""
    return _unit_spelled(plain_spelling(name)) or _unit_spelled(plain_spelling(name).removesuffix("s"))


def _unit_spelled(plain: str) -> CommonUnit | None:
    folded = [unit for code, unit in _BY_CODE.items() if code.lower() == plain.lower()]
    return _BY_CODE.get(plain) or (folded[0] if len(folded) == 1 else None)


def quantity_advice(quantity: str, key: str, name: str, known: Collection[str]) -> str:
    """Say what to do about the unknown quantity of a unit, given by key and name: the one that is meant, or a definition."""
    common = common_unit(key) or common_unit(name)
    meant = common.quantity if common else _BY_QUANTITY.get("-".join(quantity.lower().replace("_", " ").split()), "")
    if meant in known:
        return f"Did you mean {meant!r}?"
    return did_you_mean(quantity, known) or "Define it in a quantities.yaml, or pass one with -q."


def plain_spelling(name: str) -> str:
    """A spelling of a unit without what differs between spellings."""
    return name.translate(_SIGNS).replace("**", "")


def _common_units() -> Iterator[CommonUnit]:
    for quantity, units in _OUTSIDE_VSS.items():
        for unit in units.split(", "):
            key, _, name = unit.partition(" ")
            yield CommonUnit(key, name, quantity)


_BY_QUANTITY = {other: key for key, text in _QUANTITIES.items() for other in text.split()}
_BY_CODE = {code: unit for unit in _common_units() for code in (plain_spelling(unit.key), plain_spelling(unit.name))}
