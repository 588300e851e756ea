"""Values of VSS attributes as vss-tools holds them: numbers as numbers, switches as true or false."""

from collections.abc import Callable, Hashable, Mapping
from math import isfinite
from typing import Any

from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of

NO_VALUE: Any = object()
"""Result of a conversion for a value that the attribute cannot have."""


def hashed(value: Any) -> Hashable:
    """Return a hashable key that is equal for equal values."""
    if isinstance(value, dict):
        return frozenset((key, hashed(item)) for key, item in value.items())
    return tuple(map(hashed, value)) if isinstance(value, list) else value


def text(value: Any) -> Any:
    """Text, unchanged."""
    return value if isinstance(value, str) else NO_VALUE


def _flag(value: Any) -> Any:
    if isinstance(value, bool) or value in (0, 1):
        return bool(value)
    known = {"true": True, "yes": True, "on": True, "1": True, "false": False, "no": False, "off": False, "0": False}
    return known.get(str(value).lower(), NO_VALUE)


def number(value: Any) -> Any:
    """A number, also where it is written as text."""
    if isinstance(value, bool):
        return int(value)
    if isinstance(value, int | float):
        return value
    if isinstance(value, str):
        for convert in (int, float):
            try:
                return convert(value)
            except ValueError:
                continue
    return NO_VALUE


def _whole_number(value: Any) -> Any:
    found = number(value)
    return int(found) if found is not NO_VALUE and found == found // 1 else NO_VALUE


def _texts(value: Any) -> Any:
    return value if isinstance(value, list) and all(isinstance(item, str) for item in value) else NO_VALUE


def _scalars(value: Any) -> Any:
    is_list = isinstance(value, list) and all(isinstance(item, str | int | float) for item in value)
    return value if is_list else NO_VALUE


def _numbered(value: Any) -> Any:
    if not isinstance(value, dict):
        return NO_VALUE
    numbers = {key: _whole_number(item) for key, item in value.items()}
    return NO_VALUE if NO_VALUE in numbers.values() else value if numbers == value else numbers


def _instances(value: Any) -> Any:
    return value if isinstance(value, str | list) else NO_VALUE


def _relation(value: Any) -> Any:
    return value if value in ("child", "sibling") else NO_VALUE


CONVERSIONS: Mapping[str, Callable[[Any], Any]] = {
    "description": text, "comment": text, "deprecation": text, "constUID": text, "pattern": text,
    "unit": text, "datatype": text, "delete": _flag, "instantiate": _flag, "aggregate": _flag,
    "is_instance": _flag, "fka": _texts, "arraysize": _whole_number, "min": number, "max": number,
    "allowed": _scalars, "enum": _numbered, "instances": _instances, "instances_relation": _relation,
}  # fmt: skip
"""Normalization of the value of each attribute, by its name."""
EXPECTED: Mapping[str, str] = {
    "description": "text", "comment": "text", "deprecation": "text", "constUID": "text such as '0x0123ABCD'",
    "pattern": "a regular expression", "unit": "the key of a unit", "datatype": "the name of a datatype",
    "delete": "true or false", "instantiate": "true or false", "aggregate": "true or false",
    "is_instance": "true or false", "fka": "a list of former paths", "arraysize": "a whole number",
    "min": "a number", "max": "a number", "allowed": "a list of values",
    "enum": "a mapping of names to whole numbers", "instances": "text or a list",
    "instances_relation": "'child' or 'sibling'",
}  # fmt: skip
"""Required value of each attribute as text, by its name."""


def is_finite(value: Any) -> bool:
    """Whether a value has no number that JSON cannot write: `.nan` and `.inf` are numbers of YAML alone."""
    if type(value) is float:
        return isfinite(value)
    if isinstance(value, dict):
        return all(map(is_finite, value.values()))
    return not isinstance(value, list) or all(map(is_finite, value))


def is_misspelled(written: Any, meant: Any) -> bool:
    """Whether a value counts as another one that YAML has a spelling for: `'0'` as 0, `'yes'` and 1 as true."""
    return isinstance(written, str | bool | int) and type(written) is not type(meant)


def is_fraction(written: Any, meant: Any) -> bool:
    """Whether a whole number, or one in a list, is written as a fraction."""
    items = written if isinstance(written, list) else [written]
    return type(meant) in (int, list) and any(type(item) is float for item in items)


def whole_numbers(values: Mapping[str, Any]) -> dict[str, Any]:
    """The values of a whole-number datatype that are written as fractions without being any: `max: 0.0` is 0."""
    datatype = values.get("datatype")
    if not isinstance(datatype, str) or element_of(datatype) not in _WHOLE:
        return {}
    given = {name: values[name] for name in _OF_DATATYPE if name in values}
    return {name: whole for name, value in given.items() if (whole := _as_whole(value)) is not value}


_WHOLE = frozenset((*INTEGER_RANGES, "int"))
_OF_DATATYPE = ("min", "max", "default", "allowed")


def _as_whole(value: Any) -> Any:
    """A number without a fraction as a whole number, and a list with such ones; anything else, itself."""
    if type(value) is float:
        return int(value) if value.is_integer() else value
    if isinstance(value, list) and any(type(item) is float and item.is_integer() for item in value):
        return [_as_whole(item) for item in value]
    return value
