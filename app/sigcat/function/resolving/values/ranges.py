"""The range of a value in the code's unit, and whether the code can hold it."""

from fractions import Fraction

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, LARGEST_ROUNDED_TO_FLOAT, element_of, is_numeric
from sigcat.function.declaration.declaration import DataItem
from sigcat.function.document.problem import Problem, Problems
from sigcat.function.function_json.conversion import Linear
from sigcat.function.function_json.datatypes.primitive_types import value_range
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.values.code_value import CodeValue
from sigcat.function.resolving.values.numbers import fraction, shown

Range = tuple[Fraction, Fraction]
OpenRange = tuple[Fraction | None, Fraction | None]


def range_of(code: CodeValue, context: Context) -> OpenRange:
    """Smallest and largest valid value, in the code's unit. Whether they are in order is checked with the result."""
    if not (is_numeric(code.datatype) or element_of(code.datatype) == "boolean"):
        return None, None
    own = _own_range(code)
    low = own[0] if code.item.min is None else fraction(code.item.min)
    high = own[1] if code.item.max is None else fraction(code.item.max)
    context.problems.extend(_widened(code, own))
    if code.symbols is None and not is_upside_down(low, high):
        context.problems.extend(_lost(code, low, high))
        context.problems.extend(_digits_lost(code, low, high))
    context.problems.extend(_symbols_beyond(code))
    return low, high


def is_upside_down(low: Fraction | None, high: Fraction | None) -> bool:
    """Whether a range holds no value."""
    return low is not None and high is not None and low > high


def _own_range(code: CodeValue) -> OpenRange:
    """The catalogue's range in the code's unit; of an enumeration, the range of its numbers. Open if it is upside down (I103)."""
    if code.symbols:
        return Fraction(min(code.symbols.values())), Fraction(max(code.symbols.values()))
    if element_of(code.own_datatype) == "boolean":
        return Fraction(0), Fraction(1)
    bounds = [code.node.values.get(name) for name in ("min", "max")]
    low, high = (None if bound is None else code.to_code(fraction(bound)) for bound in bounds)
    if code.to_code.factor < 0:
        low, high = high, low
    return (None, None) if is_upside_down(low, high) else (low, high)


def _widened(code: CodeValue, own: OpenRange) -> Problems:
    """The code may narrow the range of a signal, not widen it."""
    if code.symbols is not None:
        return
    for name, given, bound, sign in (("min", code.item.min, own[0], 1), ("max", code.item.max, own[1], -1)):
        if given is not None and bound is not None and fraction(given) * sign < bound * sign:
            words = f"{shown(bound)} or {'more' if sign > 0 else 'less'}"
            message = f"`{name}` must be {words}, as in the catalogue, not {given}."
            fix = "Narrow it, or change the catalogue."
            yield code.problem(codes.RANGE_WIDER_THAN_CATALOGUE, (*code.at, name), message, fix)


def _symbols_beyond(code: CodeValue) -> Problems:
    limits = value_range(element_of(code.datatype))
    for name, number in (code.symbols or {}).items():
        if limits and not limits[0] <= number <= limits[1]:
            message = f"{number}, the number of {name!r}, does not fit {code.datatype}."
            yield code.problem(codes.CONVERSION_LOSES_RANGE, (*code.at, "values", name), message)


# -- what is lost -------------------------------------------------------------------------------------------------


def _lost(code: CodeValue, low: Fraction | None, high: Fraction | None) -> Problems:
    """A datatype or a scale that cannot hold what the catalogue promises, or promises less than it gives."""
    own, stored = element_of(code.own_datatype), element_of(code.datatype)
    if _is_wide(stored, own):
        yield from _beyond_float(code, low, high)
        return
    held, catalogue = _converted(_full(stored), code.scale), _converted(_full(own), code.to_code)
    if held is None or catalogue is None:
        return
    is_provided = isinstance(code.item, DataItem) and code.item.role == "provided"
    given = held if is_provided else catalogue
    needed = (given[0] if low is None else low, given[1] if high is None else high)
    for limits, holder in ((held, f"{code.datatype} in the code"), (catalogue, f"{own} in the catalogue")):
        if needed[0] < limits[0] or needed[1] > limits[1]:
            yield _overflow(code, needed, limits, holder)
            return
    is_scaled = getattr(code.item, "factor", None) is not None
    if own in ("float", "double") and stored in INTEGER_RANGES and not is_scaled and not is_provided:
        message = f"The catalogue has {own}; held as {stored} without a factor, fractions are lost."
        yield code.problem(codes.FRACTIONS_LOST, (*code.at, "datatype"), message, "Give a `factor`, such as 0.01.")


def _beyond_float(code: CodeValue, low: Fraction | None, high: Fraction | None) -> Problems:
    """Yield a problem for a limit that a float on either side cannot hold. A limit of the catalogue is checked there."""
    in_code = _converted(_FLOAT, code.scale) if element_of(code.datatype) == "float" else None
    in_catalogue = _converted(_FLOAT, code.to_code) if element_of(code.own_datatype) == "float" else None
    for key, end in (("max", high), ("min", low)):
        is_own = getattr(code.item, key) is None
        if end is None or (is_own and _is_beyond(end, in_catalogue)):
            continue
        if _is_beyond(end, in_code) or _is_beyond(end, in_catalogue):
            message = f"`{key}` {shown(end)} does not fit float, whose largest number is 3.4028235e+38."
            fix = "Choose a larger datatype or another scale, or narrow the range with `min` and `max`."
            at = code.first_written(key, "datatype", "factor", "unit")
            yield code.problem(codes.CONVERSION_LOSES_RANGE, at, message, fix)


def _is_beyond(end: Fraction, limits: Range | None) -> bool:
    return limits is not None and not limits[0] <= end <= limits[1]


_FLOAT = (Fraction(-LARGEST_ROUNDED_TO_FLOAT), Fraction(LARGEST_ROUNDED_TO_FLOAT))


def _overflow(code: CodeValue, needed: Range, limits: Range, holder: str) -> Problem:
    message = (
        f"Values from {shown(needed[0])} to {shown(needed[1])} do not fit {holder}, "
        f"which holds {shown(limits[0])} to {shown(limits[1])}."
    )
    fix = "Choose a larger datatype or another scale, or narrow the range with `min` and `max`."
    at = code.first_written("datatype", "factor", "unit", "max", "min")
    return code.problem(codes.CONVERSION_LOSES_RANGE, at, message, fix)


_DIGITS = {"float": 2**24, "double": 2**53}
"""Up to where a floating-point number tells each integer from the next."""


def _digits_lost(code: CodeValue, low: Fraction | None, high: Fraction | None) -> Problems:
    """An integer that is read as a floating-point number, or sent as one, beyond where that has each integer."""
    own, stored = element_of(code.own_datatype), element_of(code.datatype)
    is_provided = isinstance(code.item, DataItem) and code.item.role == "provided"
    integer, floating = (stored, own) if is_provided else (own, stored)
    if integer not in INTEGER_RANGES or floating not in _DIGITS:
        return
    to_integer = (code.scale if is_provided else code.to_code).inverse
    ends = [Fraction(end) for end in INTEGER_RANGES[integer]]
    given = [None if end is None else to_integer(end) for end in (low, high)]
    largest = max(abs(own if end is None else end) for own, end in zip(ends, given, strict=True))
    if largest > _DIGITS[floating]:
        message = f"{integer} up to {shown(largest)} is {'sent' if is_provided else 'held'} as {floating}, which has each integer only up to {_DIGITS[floating]}."
        fix = "Use an integer or a larger datatype, or narrow the range with `min` and `max`."
        yield code.problem(codes.DIGITS_LOST, code.first_written("datatype", "max", "min"), message, fix)


def _is_wide(stored: str, own: str) -> bool:
    """Whether the code holds every number that the catalogue's datatype holds, in any usual unit."""
    return stored == "double" or (stored == "float" and own != "double")


def _full(datatype: str) -> Range | None:
    limits = value_range(datatype)
    return (Fraction(limits[0]), Fraction(limits[1])) if limits else None


def _converted(limits: Range | None, conversion: Linear) -> Range | None:
    if limits is None:
        return None
    low, high = sorted(limit * conversion.factor + conversion.offset for limit in limits)
    return low, high
