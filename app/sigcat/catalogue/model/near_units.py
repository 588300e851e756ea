"""Units by what people write instead of their key: names, symbols, codes of UCUM (https://ucum.org)."""

import re
from collections.abc import Iterator, Mapping

from sigcat.catalogue.model.common_units import CommonUnit, common_unit, plain_spelling
from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.names import either, nearest

_SPELLINGS: Mapping[str, str] = {
    "Celsius": "degC Cel degCel centigrade",
    "Fahrenheit": "degF [degF]",
    "degrees": "deg degree",
    "radians": "rad radian",
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
_PLAIN_KEY = re.compile(r"[A-Za-z][A-Za-z0-9/^.-]*")
_LONGEST = 40


def near_unit(name: str, vocabulary: Vocabulary) -> Unit | None:
    """Return the unit of a catalogue that a spelling means."""
    plain = plain_spelling(name)
    for unit in vocabulary.distinct_units:
        if plain in (plain_spelling(unit.key), plain_spelling(unit.name)):
            return unit
    key = _BY_SPELLING.get(plain) or _BY_SPELLING.get(plain.lower())
    return vocabulary.unit(key) if key else None


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
        return f"{use} it in a units file: `{definition_of(name)}`.{_quantity_too(common, vocabulary)}"
    by_text = {text: unit for unit in vocabulary.distinct_units for text in (unit.key, unit.name)}
    meant = dict.fromkeys(_shown(by_text[text]) for text in nearest(name, by_text))
    if meant:
        return f"Did you mean {either(meant)}?"
    return f"`sigcat units` lists all. Define it in a units file: `{definition_of(name)}`."


def _shown(unit: Unit) -> str:
    return repr(unit.key) if unit.key == unit.name else f"{unit.key!r} ({unit.name})"


def _quantity_too(common: CommonUnit, vocabulary: Vocabulary) -> str:
    if common.quantity in vocabulary.quantities:
        return ""
    text = common.quantity.replace("-", " ").capitalize()
    return f" Define its quantity in a quantities.yaml: `{common.quantity}: {{definition: {text}.}}`."


def definition_of(name: str) -> str:
    """Return a definition to copy into a units file, on one line."""
    fields = ", ".join(f"{key}: {value}" for key, value in definition_fields(name))
    return f"{key_of(name)}: {{{fields}}}"


def key_of(name: str) -> str:
    """Return a name as a key of YAML; one that cannot be a unit is replaced."""
    if not name.isprintable() or len(name) > _LONGEST:
        return "UNIT"
    quoted = name.replace("'", "''")
    return name if _PLAIN_KEY.fullmatch(name) else f"'{quoted}'"


def definition_fields(name: str) -> Iterator[tuple[str, str]]:
    """Fields of a definition to copy."""
    common = common_unit(name)
    text = common.name if common else "name of the unit"
    yield "definition", f"{text[:1].upper()}{text[1:]}."
    yield "unit", text
    yield "quantity", common.quantity if common else "KEY_OF_QUANTITY"
    yield "allowed-datatypes", "[numeric]"


_BY_SPELLING = {plain_spelling(spelling): key for key, text in _SPELLINGS.items() for spelling in text.split()}
