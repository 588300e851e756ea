"""Numbers of one type as those of another, in C: their limits, factors and offsets (section 4)."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import lru_cache

from sigcat.adapter.core.c.values.literals import literal
from sigcat.adapter.core.numbers import FLOAT, NumberType, nearest_float
from sigcat.adapter.core.plan import Element
from sigcat.function.function_json.conversion import IDENTITY, Linear

Naming = Callable[[str, str], str]
"""From the kind of a constant and its literal to the text in the code: its name, or the literal itself."""
_SIGNS = {"LEAST": ">=", "GREATEST": "<="}


def _unnamed(kind: str, text: str) -> str:
    del kind
    return text


def limits(element: Element) -> Mapping[str, str]:
    """Literals of the limits that are checked, by their kinds."""
    source, least, greatest = element.source, element.least, element.greatest
    if _is_empty(element):
        return {}
    if source.is_floating and element.is_checked:
        least = float(source.smallest) if least is None else least
        greatest = float(source.largest) if greatest is None else greatest
    given = zip(_SIGNS, (least, greatest), strict=True)
    return {kind: literal(limit, source) for kind, limit in given if limit is not None}


def within(value: str, element: Element, named: Naming = _unnamed) -> str | None:
    """The condition that a number is within its range; None where all numbers of its type are."""
    if _is_empty(element):
        return "false"
    sides = [f"({value} {_SIGNS[kind]} {named(kind, text)})" for kind, text in limits(element).items()]
    return " && ".join(sides) or None


def _is_empty(element: Element) -> bool:
    """Whether the range has no number of the type. A range of floats is checked as it is written."""
    source = element.source
    if source.is_floating and element.is_checked:
        return False
    is_below = element.greatest is not None and element.greatest < source.smallest
    return is_below or (element.least is not None and element.least > source.largest)


def converted(value: str, element: Element, instead_of_nan: str, named: Naming = _unnamed) -> str:
    """The number of the source as that of the target. An enumeration has its own function."""
    if element.conversion == IDENTITY:
        return _of_same_scale(value, element, instead_of_nan)
    real = element.arithmetic
    scaled = _scaled(value, element, named)
    if element.target == FLOAT and not is_beyond_float(element):
        return scaled if real == FLOAT else f"(float){scaled}"
    if element.target == real == FLOAT:
        return f"Sigcat_ToFloat({scaled}, {value})"
    return _from_real(scaled, element.target, real, instead_of_nan)


def is_beyond_float(element: Element) -> bool:
    """Whether a finite number can become too large for a float."""
    return element.target.name == "float" and _reached(element.source, element.conversion) > element.target.largest


@lru_cache(maxsize=4096)
def _reached(source: NumberType, conversion: Linear) -> Fraction:
    """The largest number that a conversion makes of one of a type."""
    largest = max(abs(source.smallest), source.largest)
    return largest * abs(conversion.factor) + abs(conversion.offset)


def scaling(element: Element) -> Mapping[str, str]:
    """Literals of factor and offset, by their kinds: one of them, or all arguments of `Sigcat_Scaled`."""
    conversion, real = element.conversion, element.arithmetic
    (factor, factor_rest), (offset, offset_rest) = (_in_parts(number, real) for number in conversion)
    has_rest = real == FLOAT and element.source.name in _RESTS
    numbers = {"FACTOR": factor, "FACTOR_REST": factor_rest, "OFFSET": offset, "OFFSET_REST": offset_rest}
    if conversion.offset == 0 and not has_rest:
        kinds: tuple[str, ...] = ("FACTOR",)
    elif conversion.factor == 1 and offset_rest == 0 and not has_rest:
        kinds = ("OFFSET",)
    else:
        kinds = tuple(numbers) if real == FLOAT else ("FACTOR", "OFFSET")
    return {kind: literal(numbers[kind], real) for kind in kinds}


def _scaled(value: str, element: Element, named: Naming) -> str:
    numbers = {kind: named(kind, text) for kind, text in scaling(element).items()}
    real = _as_real(value, element.source, element.arithmetic)
    if len(numbers) == 1:
        ((kind, number),) = numbers.items()
        return f"({real} {'*' if kind == 'FACTOR' else '+'} {number})"
    rest = f"{_RESTS[element.source.name]}({value})" if element.source.name in _RESTS else literal(0, FLOAT)
    return f"Sigcat_Scaled({', '.join((real, *([rest] if element.arithmetic == FLOAT else []), *numbers.values()))})"


_RESTS = {"int32": "Sigcat_RestOfInt32", "uint32": "Sigcat_RestOfUint32"}
"""Functions for integers with more digits than a float."""


def _in_parts(number: Fraction, real: NumberType) -> tuple[float, float]:
    """The nearest number of the arithmetic; and of float arithmetic the nearest one to what is left."""
    if real != FLOAT:
        return float(number), 0.0
    near = nearest_float(number)
    return near, nearest_float(number - Fraction(near))


def _as_real(value: str, source: NumberType, real: NumberType) -> str:
    if source.is_boolean:
        return f"({value} ? {literal(1, real)} : {literal(0, real)})"
    return value if source == real else f"({real.c}){value}"


def _from_real(value: str, target: NumberType, real: NumberType, instead_of_nan: str) -> str:
    if target == real:
        return value
    if target.is_boolean:
        return f"({value} != {literal(0, real)})"
    if target == FLOAT:
        return f"Sigcat_ToFloat({value})"
    return f"Sigcat_To{target.name.capitalize()}({value}, {instead_of_nan})"


def _of_same_scale(value: str, element: Element, instead_of_nan: str) -> str:
    source, target, real = element.source, element.target, element.arithmetic
    if source == target:
        return value
    if target.is_boolean:
        return f"({value} != {literal(0, source)})"
    if source.is_boolean:
        return f"({value} ? {literal(1, target)} : {literal(0, target)})"
    if source.is_floating:
        return _from_real(_as_real(value, source, real), target, real, instead_of_nan)
    if target.is_floating or (source.smallest >= target.smallest and source.largest <= target.largest):
        return f"({target.c}){value}"
    wide = "Uint64" if source.name == "uint64" else "Int64"
    return f"Sigcat_{wide}To{target.name.capitalize()}({value})"
