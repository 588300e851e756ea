"""Units by what people write instead of their key: names, symbols, codes of UCUM (https://ucum.org)."""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.names import did_you_mean

_SPELLINGS: Mapping[str, str] = {
    "Celsius": "degC Cel degCel centigrade",
    "Fahrenheit": "degF [degF]",
    "degrees": "deg degree",
    "degrees/s": "deg/s dps",
    "rad/s": "rads-1",
    "rpm": "1/min r/min rev/min min-1 {rev}/min",
    "km/h": "kmh kph kmph kmh-1",
    "m/s": "mps ms-1",
    "m/s^2": "mps2 ms-2",
    "cm^3": "ccm cc",
    "l": "litre ltr",
    "ml": "millilitre",
    "mm": "millimetre",
    "cm": "centimetre",
    "m": "metre",
    "km": "kilometre",
    "inch": "in [in_i] inches",
    "lbs": "lb [lb_av] pounds",
    "percent": "% pct",
    "ratio": "1",
    "Ohm": "Ω ohms",
    "s": "sec seconds",
    "min": "minutes",
    "h": "hr hours",
    "day": "d",
    "weeks": "wk week",
    "months": "mo month",
    "years": "a yr year",
    "unix-time": "unix epoch timestamp",
    "iso8601": "datetime",
    "mbar": "hPa",
    "psi": "[psi]",
    "Nm": "N*m newtonmeters",
    "A": "amp amps amperes",
    "V": "volts",
    "W": "watts",
    "lx": "lx lumen/m2",
    "kWh": "kW*h",
    "Ah": "A*h",
}
"""Other spellings of units of VSS, several in one text."""
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
_SIGNS = str.maketrans({"µ": "u", "μ": "u", "²": "2", "³": "3", "·": None, "^": None, "_": None, " ": None, "°": "deg"})
_PLAIN_KEY = re.compile(r"[A-Za-z][A-Za-z0-9/^.-]*")
_LONGEST = 40


class CommonUnit(NamedTuple):
    """A unit that VSS does not define."""

    key: str
    name: str
    quantity: str


def near_unit(name: str, vocabulary: Vocabulary) -> Unit | None:
    """Return the unit of a catalogue that a spelling means."""
    plain = _plain(name)
    for unit in vocabulary.distinct_units:
        if plain in (_plain(unit.key), _plain(unit.name)):
            return unit
    key = _BY_SPELLING.get(plain) or _BY_SPELLING.get(plain.lower())
    return vocabulary.unit(key) if key else None


def common_unit(name: str) -> CommonUnit | None:
    """Return the unit outside VSS that a spelling means."""
    plain = _plain(name)
    folded = [unit for code, unit in _BY_CODE.items() if code.lower() == plain.lower()]
    return _BY_CODE.get(plain) or (folded[0] if len(folded) == 1 else None)


def spellings_of(unit: Unit) -> str:
    """Return the other spellings of a unit, for a search."""
    return _SPELLINGS.get(unit.key, "")


def advice(name: str, vocabulary: Vocabulary) -> str:
    """Say what to do about an unknown unit: the unit that is meant, or how to define one."""
    near = near_unit(name, vocabulary)
    if near is not None:
        return f"Write `{near.key}`: {near.name}."
    common = common_unit(name)
    if common is not None:
        alike = [unit.key for unit in vocabulary.distinct_units if unit.quantity == common.quantity]
        use = f"Use a unit of {common.quantity} ({', '.join(alike)}), or define" if alike else "Define"
        return f"{use} it in a units file: `{definition_of(name, vocabulary)}`.{_quantity_too(common, vocabulary)}"
    meant = did_you_mean(name, dict.fromkeys(unit.key for unit in vocabulary.distinct_units))
    return meant or f"`sigcat units` lists all. Define it in a units file: `{definition_of(name, vocabulary)}`."


def _quantity_too(common: CommonUnit, vocabulary: Vocabulary) -> str:
    if common.quantity in vocabulary.quantities:
        return ""
    text = common.quantity.replace("-", " ").capitalize()
    return f" Define its quantity in a quantities.yaml: `{common.quantity}: {{definition: {text}.}}`."


def definition_of(name: str, vocabulary: Vocabulary) -> str:
    """Return a definition to copy into a units file, on one line."""
    fields = ", ".join(f"{key}: {value}" for key, value in definition_fields(name, vocabulary))
    return f"{key_of(name)}: {{{fields}}}"


def key_of(name: str) -> str:
    """Return a name as a key of YAML; one that cannot be a unit is replaced."""
    if not name.isprintable() or len(name) > _LONGEST:
        return "UNIT"
    quoted = name.replace("'", "''")
    return name if _PLAIN_KEY.fullmatch(name) else f"'{quoted}'"


def definition_fields(name: str, vocabulary: Vocabulary) -> Iterator[tuple[str, str]]:
    """Fields of a definition to copy."""
    common = common_unit(name)
    text = common.name if common else "name of the unit"
    yield "definition", f"{text[:1].upper()}{text[1:]}."
    yield "unit", text
    yield "quantity", common.quantity if common else next(iter(vocabulary.quantities), "length")
    yield "allowed-datatypes", "[numeric]"


def _plain(name: str) -> str:
    return name.translate(_SIGNS).replace("**", "")


def _common_units() -> Iterator[CommonUnit]:
    for quantity, units in _OUTSIDE_VSS.items():
        for unit in units.split(", "):
            key, _, name = unit.partition(" ")
            yield CommonUnit(key, name, quantity)


_BY_SPELLING = {_plain(spelling): key for key, text in _SPELLINGS.items() for spelling in text.split()}
_BY_CODE = {code: unit for unit in _common_units() for code in (_plain(unit.key), _plain(unit.name))}
