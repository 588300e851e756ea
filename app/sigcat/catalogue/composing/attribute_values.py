"""Values of VSS attributes as vss-tools holds them: numbers as numbers, switches as true or false."""

from collections.abc import Callable, Mapping
from typing import Any

NO_VALUE: Any = object()
"""What a conversion returns for a value that the attribute cannot have."""


def text(value: Any) -> Any:
    """Text, unchanged."""
    return value if isinstance(value, str) else NO_VALUE


def _flag(value: Any) -> Any:
    if isinstance(value, bool):
        return value
    known = {"true": True, "yes": True, "on": True, "1": True, "false": False, "no": False, "off": False, "0": False}
    return known.get(str(value).lower(), NO_VALUE)


def _number(value: Any) -> Any:
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


def _whole(value: Any) -> Any:
    number = _number(value)
    return int(number) if number is not NO_VALUE and number == number // 1 else NO_VALUE


def _texts(value: Any) -> Any:
    return value if isinstance(value, list) and all(isinstance(item, str) for item in value) else NO_VALUE


def _scalars(value: Any) -> Any:
    is_list = isinstance(value, list) and all(isinstance(item, str | int | float) for item in value)
    return value if is_list else NO_VALUE


def _numbered(value: Any) -> Any:
    if not isinstance(value, dict):
        return NO_VALUE
    numbers = {key: _whole(item) for key, item in value.items()}
    return NO_VALUE if NO_VALUE in numbers.values() else value if numbers == value else numbers


def _instances(value: Any) -> Any:
    return value if isinstance(value, str | list) else NO_VALUE


def _relation(value: Any) -> Any:
    return value if value in ("child", "sibling") else NO_VALUE


CONVERSIONS: Mapping[str, Callable[[Any], Any]] = {
    "description": text, "comment": text, "deprecation": text, "constUID": text, "pattern": text,
    "unit": text, "datatype": text, "delete": _flag, "instantiate": _flag, "aggregate": _flag,
    "is_instance": _flag, "fka": _texts, "arraysize": _whole, "min": _number, "max": _number,
    "allowed": _scalars, "enum": _numbered, "instances": _instances, "instances_relation": _relation,
}  # fmt: skip
"""How the value of each attribute is normalized, by its name."""
EXPECTED: Mapping[str, str] = {
    "description": "text", "comment": "text", "deprecation": "text", "constUID": "text such as '0x0123ABCD'",
    "pattern": "a regular expression", "unit": "the key of a unit", "datatype": "the name of a datatype",
    "delete": "true or false", "instantiate": "true or false", "aggregate": "true or false",
    "is_instance": "true or false", "fka": "a list of former paths", "arraysize": "a whole number",
    "min": "a number", "max": "a number", "allowed": "a list of values",
    "enum": "a mapping of names to whole numbers", "instances": "text or a list",
    "instances_relation": "'child' or 'sibling'",
}  # fmt: skip
"""What the value of each attribute must be, by its name, in words."""
