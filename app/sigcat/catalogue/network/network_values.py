"""Conversion of a network value by a mapping: to the signal's datatype, or the reason why this is impossible."""

import math
import struct
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from sigcat.catalogue.model.datatypes import FLOATING, INTEGER_RANGES
from sigcat.catalogue.network.mapping import SignalMapping

if TYPE_CHECKING:
    from sigcat.catalogue.network.formula import Formula

Value = bool | int | float | str


class NetworkValue(NamedTuple):
    """A value of a network's signal."""

    raw: float
    """The number as it is transmitted."""
    physical: float
    """The number in the unit of the signal."""
    name: str | None = None
    """Name of this raw number in the database, if it has one."""
    is_within: bool = True
    """Whether the limits of the database include it."""


class Unfit(Exception):
    """Why a value of the network is none of the signal: a few words, by which such values are counted."""


WORD, NO_FORMULA_VALUE, UNLISTED = "words where a number belongs", "no result of `math`", "not among the listed values"
OUTSIDE = "outside of the limits that the database states"
NAMED = "named by the database, and not a number for `math`"
NOT_ALLOWED, NOT_HELD = "not among the `allowed` values", "not held by the datatype"


def value_of(given: NetworkValue, mapping: SignalMapping, datatype: str, allowed: frozenset[Any]) -> Value:
    """The value of the signal. Raises Unfit."""
    value = _of_profile(given, mapping, datatype) if mapping.is_profile else _of_kuksa(given, mapping, datatype)
    fitted = in_datatype(value, datatype)
    if allowed and fitted not in allowed:
        raise Unfit(NOT_ALLOWED)
    return fitted


def _of_kuksa(given: NetworkValue, mapping: SignalMapping, datatype: str) -> Any:
    if mapping.choices:
        for choice in mapping.choices:
            if _is_given(choice.given, given):
                return choice.meant
        raise Unfit(UNLISTED)
    return _converted(given, mapping, datatype)


def _is_given(wanted: Any, given: NetworkValue) -> bool:
    """Whether an item of a list is about a value: by its name, else by its number."""
    if isinstance(wanted, str):
        return wanted == given.name
    return bool(wanted == (given.physical if given.name is None else given.raw))


def _of_profile(given: NetworkValue, mapping: SignalMapping, datatype: str) -> Any:
    """The value of a representation, else of the formula.

    A text signal gets the text of the number that was transmitted, a number the one beside the name of the network.
    """
    if datatype == "string":
        found = [each.meant for each in mapping.choices if each.given in (given.raw, given.name)]
    else:
        found = [each.given for each in mapping.choices if given.name is not None and each.meant == given.name]
    if found:
        return found[0]
    if given.raw in mapping.markers:
        raise Unfit(WORD)
    if mapping.choices and mapping.formula is None:
        raise Unfit(UNLISTED)
    return _converted(given, mapping, datatype)


def _converted(given: NetworkValue, mapping: SignalMapping, datatype: str) -> Any:
    if mapping.formula is not None:
        return _computed(given, mapping.formula)
    if datatype == "string":
        if given.name is None:
            raise Unfit("numbers without a name where a text belongs")
        return given.name
    if not given.is_within:
        raise Unfit(OUTSIDE)
    return given.physical if given.name is None else given.raw


def _computed(given: NetworkValue, formula: "Formula") -> Any:
    if given.name is not None:
        raise Unfit(NAMED)
    found = formula.value(given.physical)
    if found is None or _is_no_result(given.physical, found):
        raise Unfit(NO_FORMULA_VALUE)
    return found


def _is_no_result(number: float, found: float) -> bool:
    """NaN >= 1 has no result, and 1e308 * 10 is not a finite number."""
    if math.isnan(number):
        return not math.isnan(found)
    return math.isfinite(number) and not math.isfinite(found)


def in_datatype(value: Any, datatype: str) -> Value:
    """A value as the datatype has it: whole numbers by rounding, to even where two are as near. Raises Unfit."""
    if datatype == "string":
        return value if isinstance(value, str) else _text(value)
    if isinstance(value, str):
        if datatype == "boolean" and value.lower() in _BOOLEANS:
            return _BOOLEANS[value.lower()]
        raise Unfit(WORD)
    if datatype == "boolean":
        if math.isnan(value):
            raise Unfit(NOT_HELD)
        return bool(value)
    if datatype in INTEGER_RANGES:
        return _rounded_in_range(value, *INTEGER_RANGES[datatype])
    return _floating(float(value), datatype)


_BOOLEANS: Mapping[str, bool] = {"true": True, "false": False}


def _text(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _rounded_in_range(value: float, least: int, greatest: int) -> int:
    if isinstance(value, float) and not math.isfinite(value):
        raise Unfit(NOT_HELD)
    whole = round(value)
    if not least <= whole <= greatest:
        raise Unfit(NOT_HELD)
    return whole


def _floating(value: float, datatype: str) -> float:
    if datatype not in FLOATING:
        raise Unfit(NOT_HELD)
    if datatype == "double":
        return value
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        raise Unfit(NOT_HELD) from None
