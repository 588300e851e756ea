"""A value as it is in a cell of a CSV file: read exactly, and written so that it can be read again.

Numbers have all their digits: of a double and of a float the fewest that give it again. Symbols mean the numbers
of enumerations, lists and mappings of JSON for arrays and structs.
"""

import json
import math
import re
import struct
from decimal import Decimal
from functools import lru_cache
from typing import Any

from sigcat.adapter.host.shapes import ERROR_CODE, SECONDS, Array, Number, Record, Shape, Value
from sigcat.catalogue.model.datatypes import FLOATING, INTEGER_RANGES
from sigcat.findings import shown
from sigcat.names import did_you_mean
from sigcat.runs.recording.times import LIMITS, nanoseconds

LARGEST_FLOAT = float(struct.unpack(">f", bytes.fromhex("7f7fffff"))[0])
_SMALLEST_NORMAL = 2.0**-126
_WHOLE = 2**53
"""Up to here a double holds every whole number."""
_BOOLEANS = {"true": True, "false": False}
_ERROR_CODE = re.compile("0[xX][0-9a-fA-F]{1,2}|[0-9]{1,3}")
_LARGEST_CODE = 0xFF


class Unfit(Exception):
    """Why a text is no such value: `must be …, not …`, and what to do."""

    def __init__(self, message: str, fix: str = "") -> None:
        super().__init__(message)
        self.fix = fix


class Literal(float):
    """A number of JSON that its double does not tell all of: one beyond doubles, or between two floats."""

    text: str

    @classmethod
    def of(cls, number: float, text: str) -> "Literal":
        """A number with its text."""
        found = cls(number)
        found.text = text
        return found


def exact_float(text: str) -> float:
    """A number with a point of JSON, for `parse_float`; with its text where that is needed to round it once."""
    number = float(text)
    return Literal.of(number, text) if math.isinf(number) or _is_between_floats(number) else number


# -- reading ------------------------------------------------------------------------------------------------------


def value_of(text: str, shape: Shape) -> Value:
    """The value of a cell. Raises Unfit."""
    if isinstance(shape, Number):
        return _number(text.strip(), shape)
    try:
        given = json.loads(text, parse_float=exact_float, object_pairs_hook=_without_duplicates)
    except (ValueError, RecursionError):
        what = "a JSON list" if isinstance(shape, Array) else "a JSON mapping"
        raise Unfit(f"must be {what}, not {shown(text)}") from None
    return fitted(given, shape)


def fitted(given: Any, shape: Shape) -> Value:
    """A value of JSON in a shape. Raises Unfit."""
    if isinstance(shape, Number):
        return _number(given if isinstance(given, str) and shape.symbols else _text(given), shape)
    if isinstance(shape, Array):
        if not isinstance(given, list) or len(given) != shape.length:
            found = f"one of {len(given)}" if isinstance(given, list) else shown(_text(given))
            raise Unfit(f"must be a list of {shape.length} elements, not {found}")
        if _are_numbers(given, shape.element):
            return list(map(float, given))
        return [_inner(element, shape.element, f"element {number}") for number, element in enumerate(given)]
    names = [name for name, _ in shape.fields]
    if not isinstance(given, dict) or set(given) != set(names):
        raise Unfit(f"must be a mapping with {', '.join(names)}, not {shown(_text(given))}")
    return {name: _inner(given[name], field, name) for name, field in shape.fields}


def _inner(given: Any, shape: Shape, place: str) -> Value:
    """A member or an element. Raises Unfit with its place."""
    try:
        return fitted(given, shape)
    except Unfit as reason:
        raise Unfit(f"must have a valid {place}: it {reason}", reason.fix) from None


def _without_duplicates(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """A mapping of JSON. Raises Unfit for a name that is given twice."""
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise Unfit(f"must have each member once, and {shown(twice)} is given twice")
    return found


def _are_numbers(given: list[Any], shape: Shape) -> bool:
    """Whether these need no further look: most arrays are of many numbers with a point."""
    if not isinstance(shape, Number) or shape.datatype not in FLOATING or {*map(type, given)} - {int, float}:
        return False
    return all(
        -LARGEST_FLOAT <= each <= LARGEST_FLOAT and (type(each) is float or abs(each) <= _WHOLE) for each in given
    )


def _text(given: Any) -> str:
    """A value as JSON, which has been read from there."""
    if isinstance(given, Literal):
        return given.text
    return repr(given) if isinstance(given, float) else json.dumps(given, ensure_ascii=False)


@lru_cache(maxsize=4096)
def _number(text: str, shape: Number) -> Value:
    if shape.datatype in FLOATING:
        return _floating(text, shape.datatype)
    if shape == SECONDS:
        return _time(text)
    if shape == ERROR_CODE:
        return _error_code(text)
    if shape.symbols:
        found = next((number for symbol, number in shape.symbols if symbol == text), None)
        return _symbol_by_number(text, shape) if found is None else found
    return _boolean(text) if shape.datatype == "boolean" else _integer_in_range(text, shape.datatype)


def _time(text: str) -> int:
    time = nanoseconds(text)
    if time is None:
        raise Unfit(f"must be a time in seconds, {LIMITS}, not {shown(text)}")
    return time


def _error_code(text: str) -> int:
    if _ERROR_CODE.fullmatch(text) and (code := int(text, 16 if text[1:2] in "xX" else 10)) <= _LARGEST_CODE:
        return code
    raise Unfit(f"must be a code from 0 to {_LARGEST_CODE}, such as 0x33, not {shown(text)}")


def _symbol_by_number(text: str, shape: Number) -> int:
    """An enumeration by its number, which may be one that has no symbol: functions have to bear that."""
    try:
        return _integer_in_range(text, shape.datatype)
    except Unfit:
        symbols = [symbol for symbol, _ in shape.symbols]
        raise Unfit(f"must be {_any_of(symbols)}, not {shown(text)}", did_you_mean(text, symbols)) from None


def _any_of(symbols: list[str]) -> str:
    return symbols[0] if len(symbols) == 1 else f"{', '.join(symbols[:-1])} or {symbols[-1]}"


def _boolean(text: str) -> bool:
    found = _BOOLEANS.get(text.lower())
    if found is not None:
        return found
    try:
        return bool(_integer_in_range(text, "boolean"))
    except Unfit:
        raise Unfit(f"must be true or false, not {shown(text)}") from None


def _integer_in_range(text: str, datatype: str) -> int:
    least, greatest = INTEGER_RANGES.get(datatype, (0, 1))
    number = _integer(text)
    if number is None or not least <= number <= greatest:
        raise Unfit(f"must be a whole number from {least} to {greatest}, not {shown(text)}")
    return number


def _integer(text: str) -> int | None:
    """A whole number, also as tables write it that know no other: 3.0."""
    try:
        return int(text) if _is_plain(text) else None
    except ValueError:
        number = _float(text)
        return int(number) if number is not None and number.is_integer() else None


def _floating(text: str, datatype: str) -> float:
    number = _float(text)
    if number is None:
        raise Unfit(f"must be a number, not {shown(text)}")
    number = _to_round_once(number, text) if datatype == "float" else number
    if not -LARGEST_FLOAT <= number <= LARGEST_FLOAT and not _is_held(number, text, datatype):
        raise Unfit(f"must fit a {datatype}, not {shown(text)}")
    return number


def _to_round_once(number: float, text: str) -> float:
    """A double that gives the float nearest to a text. One between two floats is moved to the side of the text."""
    if not _is_between_floats(number):
        return number
    exact, double = Decimal(text), Decimal(number)
    return number if exact == double else math.nextafter(number, math.inf if exact > double else -math.inf)


def _is_between_floats(number: float) -> bool:
    """Whether two floats are equally near."""
    if abs(number) < _SMALLEST_NORMAL:
        return math.ldexp(abs(number), 150) % 2 == 1
    return int.from_bytes(struct.pack("<d", number)[:4], "little") & 0x1FFFFFFF == 0x10000000


def _float(text: str) -> float | None:
    try:
        number = float(text)
    except ValueError:
        return None
    return number if _is_plain(text) else None


def _is_plain(text: str) -> bool:
    """Whether it has no digits of other scripts and no underscores, which Python takes."""
    return text.isascii() and "_" not in text


def _is_held(number: float, text: str, datatype: str) -> bool:
    """Whether a number that is large, or none, is what the text says: infinity only if it says so."""
    if math.isinf(number):
        return "inf" in text.lower()
    return datatype == "double" or math.isnan(number) or _as_float(number) is not None


# -- writing ------------------------------------------------------------------------------------------------------


def cell_of(value: Value, shape: Shape) -> str:
    """The text of a value, without the quotes that CSV may need."""
    if isinstance(shape, Number):
        return _number_text(value, shape)
    return json_text(value, shape)


def json_text(value: Value, shape: Shape, null: str = "") -> str:
    """The text of a value within a document of JSON; `null` is written for numbers that JSON does not have."""
    if isinstance(shape, Array):
        return f"[{','.join(json_text(element, shape.element, null) for element in value)}]"
    if isinstance(shape, Number):
        text = _number_text(value, shape)
        if word := _JSON_WORDS.get(text):
            return null or word
        return json.dumps(text) if shape.symbols and not _is_number(text) else text
    return (
        f"{{{','.join(f'{json.dumps(name)}:{json_text(value[name], field, null)}' for name, field in shape.fields)}}}"
    )


def plain_text(value: Value, shape: Shape) -> str:
    """The text of a value without JSON: its numbers and names, separated by semicolons, which no name has."""
    if isinstance(shape, Array):
        return ";".join(plain_text(element, shape.element) for element in value)
    if isinstance(shape, Record):
        return ";".join(plain_text(value[name], field) for name, field in shape.fields)
    return _number_text(_as_float(value) if shape.datatype == "float" else value, shape)


_JSON_WORDS = {"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity"}


def _is_number(text: str) -> bool:
    return text.removeprefix("-").isdigit()


def _number_text(value: Value, shape: Number) -> str:
    if shape.symbols:
        return next((symbol for symbol, number in shape.symbols if number == value), str(value))
    if shape.datatype == "boolean":
        return "true" if value else "false"
    return _float_text(value) if shape.datatype == "float" and value else repr(value)


@lru_cache(maxsize=4096)
def _float_text(value: float) -> str:
    """A number of binary32, rounded to as few digits as give it again. Not for 0, of which there are two."""
    for digits in range(6 if abs(value) >= _SMALLEST_NORMAL else 1, 10):
        near = float(f"{value:.{digits}g}")
        if _as_float(near) == value:
            return repr(near)
    return repr(value)  # NaN


def _as_float(value: float) -> float | None:
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        return None
