"""The datatypes of VSS: which values each holds, and which datatype a unit accepts.

Source: VSS documentation, «Data Types»; meaning as in vss-tools 6.1.
"""

from collections.abc import Mapping
from math import inf
from typing import Any

INTEGER_RANGES: Mapping[str, tuple[int, int]] = {
    "uint8": (0, 2**8 - 1),
    "int8": (-(2**7), 2**7 - 1),
    "uint16": (0, 2**16 - 1),
    "int16": (-(2**15), 2**15 - 1),
    "uint32": (0, 2**32 - 1),
    "int32": (-(2**31), 2**31 - 1),
    "uint64": (0, 2**64 - 1),
    "int64": (-(2**63), 2**63 - 1),
}
FLOATING = ("float", "double")
LARGEST_ROUNDED_TO_FLOAT = 3.4028235677973362e38
"""Largest double whose nearest number of binary32 is finite: 3.4028235e+38, the usual spelling of its largest one, is smaller."""
PRIMITIVES = frozenset((*INTEGER_RANGES, *FLOATING, "boolean", "string", "numeric"))
DATATYPES = PRIMITIVES | {f"{name}[]" for name in PRIMITIVES} | {"int"}
"""Every predefined datatype. `int` and `numeric` are families: VSS uses them for the datatypes of units."""

_NUMBERS = frozenset((*INTEGER_RANGES, *FLOATING))
_FAMILIES: Mapping[str, frozenset[str]] = {"int": frozenset(INTEGER_RANGES), "numeric": _NUMBERS}


def is_array(datatype: str) -> bool:
    """Whether the datatype is an array: `uint8[]`."""
    return datatype.endswith("[]")


def element_of(datatype: str) -> str:
    """Datatype of the elements of an array; a datatype that is not an array, unchanged."""
    return datatype.removesuffix("[]")


def is_numeric(datatype: str) -> bool:
    """Whether values of the datatype, or the elements of the array, are numbers."""
    return element_of(datatype) in _NUMBERS


def belongs_to(datatype: str, family: str) -> bool:
    """Whether `datatype` may be used where `family` is required; smaller integers fit larger ones."""
    if datatype == family or datatype in _FAMILIES.get(family, ()):
        return True
    if is_array(datatype) and is_array(family):
        return belongs_to(element_of(datatype), element_of(family))
    return (
        datatype in INTEGER_RANGES
        and family in INTEGER_RANGES
        and datatype.startswith("u") == family.startswith("u")
        and INTEGER_RANGES[datatype][1] < INTEGER_RANGES[family][1]
    )


def holds(datatype: str, value: Any) -> bool:
    """Whether a predefined datatype holds `value`; for a list, whether it holds every element."""
    values = value if isinstance(value, list) else [value]
    name = element_of(datatype)
    if name in INTEGER_RANGES:
        low, high = INTEGER_RANGES[name]
        return all(isinstance(item, int) and low <= item <= high for item in values)
    if name == "boolean":
        return all(isinstance(item, bool) for item in values)
    if name == "string":
        return all(isinstance(item, str) for item in values)
    is_alike = all(isinstance(item, float) for item in values) or all(isinstance(item, int) for item in values)
    return is_alike and (name != "float" or not any(LARGEST_ROUNDED_TO_FLOAT < abs(item) < inf for item in values))


_WORDS = {"boolean": "true or false", "string": "text", "int": "whole numbers", "float": "numbers up to ±3.4028235e+38"}


def values_in_words(datatype: str) -> str:
    """Return the values of a predefined datatype, or of the elements of an array: `0 to 255`."""
    name = element_of(datatype)
    if name in INTEGER_RANGES:
        low, high = INTEGER_RANGES[name]
        return f"{low} to {high}"
    return _WORDS.get(name, "numbers")
