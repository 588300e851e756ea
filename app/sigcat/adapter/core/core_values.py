"""A value between the catalogue and the code: its leaves, with their limits and conversions (sections 4 and 5)."""

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.numbers import (
    DOUBLE,
    FLOAT,
    Number,
    NumberType,
    brought_to,
    greatest_limit,
    least_limit,
    number_type,
    type_of_c,
)
from sigcat.adapter.core.plan import Element, Leaf, Value, WireType
from sigcat.adapter.core.planning import Context
from sigcat.function.document.document import Pointer
from sigcat.function.document.text import json_of
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_text, of_text
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue
from sigcat.function.function_json.datatypes.type_list import smallest_integer
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal

Interface = Signal | DataQueue | ParameterInterface


class Part(NamedTuple):
    """A number, or an array of numbers, that a datatype is made of."""

    wire: str
    """Position in the catalogue's value: ``, `.x`, `[i]`."""
    code: str
    """Position in the variable."""
    path: tuple[str | None, ...]
    """Members that lead to it, and None for the elements of an array."""
    length: int | None
    type: NumberType
    symbols: tuple[EnumerationValue, ...] | None
    least: Fraction | None = None
    """Limits of a member, which has its own."""
    greatest: Fraction | None = None

    @property
    def keys(self) -> tuple[str, ...]:
        """Members that lead to it."""
        return tuple(key for key in self.path if key is not None)


class Side(NamedTuple):
    """Structure of a part on one side: in the catalogue, or in the code."""

    type: NumberType
    numbers: tuple[EnumerationValue, ...] | None
    scale: Linear
    """From the physical value, in the code's unit, to what is held."""
    is_catalogue: bool = False
    unit: str = ""
    """Unit of the number; empty if it has none, or another factor."""

    def of(self, physical: Fraction) -> Fraction:
        """A number of the document on this side. The document has doubles in the code's unit: in the catalogue's unit
        the shortest decimal number that gives this double is meant."""
        if not self.is_catalogue or self.scale == IDENTITY:
            return self.scale(physical)
        return _shortest(physical, self.scale)


_FINEST = 345
"""Decimal places of any double."""


@lru_cache(maxsize=4096)
def _shortest(physical: Fraction, scale: Linear) -> Fraction:
    """The shortest decimal number that gives the double of a physical value again."""
    exact, wanted, back = scale(physical), float(physical), scale.inverse
    digits = range(-len(str(abs(round(exact)))), _FINEST)
    near = (round(exact, places) for places in digits)
    return next((number for number in near if float(back(number)) == wanted), exact)


def value_of(item: Interface, at: Pointer, context: Context, *, to_code: bool) -> Value | None:
    """The value of an interface, from the catalogue to the code or back. None if the core cannot carry it."""
    for key, text in (("Factor", getattr(item, "factor", None)), ("ConversionFactor", item.conversion_factor)):
        if text is not None and not _number(text):
            message = f"{key} of {item.name} must be a number other than 0, not {text!r}."
            context.report(codes.VALUE_NOT_CARRIED, (*at, key), message)
            return None
    members = {member.name: member.member for member in item.members or ()}
    parts, what = parts_of(item.datatype, members, context)
    if not parts:
        message = f"{item.name} cannot be carried: {what}."
        context.report(
            codes.VALUE_NOT_CARRIED,
            (*at, "Datatype"),
            message,
            "Give it another datatype; an array needs an `arraysize`.",
        )
        return None
    is_struct = any(part.keys for part in parts)
    leaves = tuple([_leaf(item, part, context.arithmetic, to_code=to_code, is_struct=is_struct) for part in parts])
    if any(_is_inexact(leaf.element) for leaf in leaves):
        message = f"{item.name} cannot be converted: a double does not hold 64-bit integers."
        context.report(codes.VALUE_NOT_CARRIED, at, message, "Give both sides the same unit, or 32 bits.")
        return None
    if context.arithmetic == FLOAT and _is_beyond_float_arithmetic(item, leaves, at, context, to_code=to_code):
        return None
    wire = _wire_type(item, parts, leaves, context, to_code=to_code)
    return Value(wire, leaves, is_bare=len(parts) == 1 and not is_struct and parts[0].length is None)


def _is_inexact(element: Element) -> bool:
    return element.conversion != IDENTITY and (element.source.is_wide or element.target.is_wide)


_MOST = Fraction(2**64)
"""Largest factor and offset of float arithmetic, and the smallest one is its reciprocal: products neither overflow nor
lose digits."""


def _is_beyond_float_arithmetic(
    item: Interface, leaves: Iterable[Leaf], at: Pointer, context: Context, *, to_code: bool
) -> bool:
    elements = [leaf.element for leaf in leaves]
    numbers = [abs(number) for element in elements for number in element.conversion if number != 0]
    if any((element.target if to_code else element.source) == DOUBLE for element in elements):
        message = f"The variable of {item.name} must not be a double in a core with float arithmetic."
        fix = "Give it the datatype float"
    elif any(DOUBLE in (element.source, element.target) for element in elements):
        message = f"{item.name} must not be a double in the catalogue for a core with float arithmetic."
        fix = "Give the signal the datatype float in an overlay"
    elif not all(1 / _MOST <= number <= _MOST for number in numbers):
        message = f"Factor and offset of {item.name} must be between 2⁻⁶⁴ and 2⁶⁴ in a core with float arithmetic."
        fix = "Choose another unit"
    else:
        return False
    context.report(
        codes.BEYOND_FLOAT_ARITHMETIC, at, message, f"{fix}, or generate the core with `--arithmetic double`."
    )
    return True


# -- parts of a datatype ------------------------------------------------------------------------------------------


def parts_of(reference: str, members: Mapping[str, str], context: Context) -> tuple[tuple[Part, ...], str]:
    """The parts of a datatype; or none, and why."""
    try:
        return tuple(_parts(reference, "", "", (), None, members, context, depth=0)), ""
    except _NotCarried as reason:
        return (), str(reason)


class _NotCarried(Exception):
    """Why a datatype has no parts."""


_DEEPEST = 16
MOST_ELEMENTS = 65_535
"""Elements of an array: no control unit has more in one signal, and start values of each are written out."""


def _parts(
    reference: str, wire: str, code: str, path: tuple[str | None, ...], length: int | None, members: Mapping[str, str],
    context: Context, depth: int,
) -> Iterator[Part]:  # fmt: skip
    datatype = context.datatypes.get(reference)
    if datatype is None or depth > _DEEPEST:
        raise _NotCarried(f"the datatype {reference} is not known" if datatype is None else "its structs are too deep")
    if datatype.kind == "struct":
        for field in datatype.fields or ():
            name = ".".join((*(key for key in path if key is not None), field.name))
            ends = f"{wire}.{identifier(field.name)}", f"{code}.{members.get(name, field.name)}"
            deeper = _parts(field.datatype, *ends, (*path, field.name), length, members, context, depth + 1)
            yield from (_limited(part, field.min, field.max) for part in deeper)
    elif datatype.kind == "array":
        if datatype.length is not None and datatype.length > MOST_ELEMENTS:
            raise _NotCarried(f"its array has more than {MOST_ELEMENTS:,} elements")
        if datatype.length is not None and datatype.length < 1:
            raise _NotCarried("its array has no elements")
        if length is not None or datatype.length is None:
            raise _NotCarried("arrays within arrays are not carried" if length else "the length of its array is open")
        ends = f"{wire}[i]", f"{code}[i]"
        yield from _parts(datatype.element or "", *ends, (*path, None), datatype.length, members, context, depth + 1)
    else:
        yield Part(wire, code, path, length, _number_type(datatype), datatype.symbols)


def _limited(part: Part, least: float | None, greatest: float | None) -> Part:
    """A part with the limits of its member, unless a deeper one has its own."""
    return part._replace(
        least=part.least if part.least is not None or least is None else Fraction(repr(least)),
        greatest=part.greatest if part.greatest is not None or greatest is None else Fraction(repr(greatest)),
    )


def _number_type(datatype: Datatype) -> NumberType:
    found = type_of_c(datatype.c_definition)
    if found is None:
        raise _NotCarried(f"{datatype.c_definition} does not hold a number of a fixed size")
    return found


# -- from one side to the other -----------------------------------------------------------------------------------


def _leaf(item: Interface, part: Part, arithmetic: NumberType, *, to_code: bool, is_struct: bool) -> Leaf:
    code, wire = _code_side(item, part, is_struct=is_struct), _wire_side(item, part, is_struct=is_struct)
    source, target = (wire, code) if to_code else (code, wire)
    is_checked = item.range_error_action is not None or item.range_error is not None
    low, high = _limits(item, part, is_struct=is_struct)
    element = Element(
        source=source.type,
        target=target.type,
        conversion=IDENTITY if part.symbols else source.scale.inverse.then(target.scale),
        names=_names(source, target),
        coded=_coded(code),
        is_checked=is_checked and not part.symbols,
        arithmetic=arithmetic,
        units=(source.unit, target.unit),
        **(_on_source(low, high, source) if is_checked and not part.symbols else {}),
    )
    init, default = _declared_numbers(item, "init", part), _declared_numbers(item, "default", part)
    return Leaf(
        *((part.wire, part.code) if to_code else (part.code, part.wire)),
        length=part.length,
        element=element,
        init=_target_numbers(init or default, part, target),
        default=_target_numbers(default or init, part, target),
        replacement=_replacement(item, init, default, part, target),
    )


def _coded(code: Side) -> tuple[int, int] | None:
    numbers = [each.value for each in code.numbers or ()]
    return (min(numbers, default=0), max(numbers, default=0)) if code.numbers is not None else None


def _code_side(item: Interface, part: Part, *, is_struct: bool) -> Side:
    factor, offset = _number(getattr(item, "factor", None)), _number(getattr(item, "offset", None))
    scale = (
        Linear(Fraction(1) if factor is None else factor, offset or Fraction(0)).inverse if factor != 0 else IDENTITY
    )
    unit = "" if is_struct else _unit(item.units or "", scale.inverse)
    return Side(part.type, part.symbols, IDENTITY if is_struct else scale, unit=unit)


def _unit(unit: str, scale: Linear) -> str:
    """The unit of a stored number: of a scaled one the step from one to the next, and what 0 means."""
    if scale == IDENTITY or not unit:
        return unit
    zero = f", 0 is {as_text(scale.offset)} {unit}" if scale.offset else ""
    return f"{as_text(scale.factor)} {unit}{zero}"


def _wire_side(item: Interface, part: Part, *, is_struct: bool) -> Side:
    if is_struct or item.vss_datatype is None:
        return _code_side(item, part, is_struct=is_struct)
    numbers = item.vss_symbols or part.symbols
    name = item.vss_datatype.removesuffix("[]")
    known = number_type(name)
    if numbers and (known is None or not known.is_integer):
        known = number_type(smallest_integer({each.symbol: each.value for each in numbers}))
    factor, offset = _number(item.conversion_factor), _number(item.conversion_offset)
    scale = Linear(Fraction(1) if factor is None else factor, offset or Fraction(0))
    unit = item.vss_unit or item.units or ""
    return Side(known or part.type, numbers if part.symbols else None, scale, is_catalogue=True, unit=unit)


def _number(value: str | float | None) -> Fraction | None:
    if isinstance(value, str):
        return of_text(value)
    return None if value is None else Fraction(repr(value))


def _names(source: Side, target: Side) -> Mapping[int, int] | None:
    if source.numbers is None or target.numbers is None:
        return None
    known = {each.symbol: each.value for each in target.numbers}
    common = [each for each in source.numbers if each.symbol in known]
    return {each.value: known[each.symbol] for each in reversed(common)}  # of two names of a number the first counts


def _limits(item: Interface, part: Part, *, is_struct: bool) -> tuple[Fraction | None, Fraction | None]:
    if is_struct:
        return part.least, part.greatest
    low, high = _number(item.min), _number(item.max)
    is_none = isinstance(item, ParameterInterface) and part.length is not None and low == high == 0
    return (None, None) if is_none else (low, high)  # of an array Function JSON requires limits where there are none


def _on_source(low: Fraction | None, high: Fraction | None, source: Side) -> dict[str, Number | None]:
    """Limits of the physical value on the scale of the source; a negative factor turns them round."""
    ends = [None if end is None else source.of(end) for end in (low, high)]
    least, greatest = ends if source.scale.factor > 0 else reversed(ends)
    return {
        "least": None if least is None else least_limit(least, source.type),
        "greatest": None if greatest is None else greatest_limit(greatest, source.type),
    }


# -- values that are given ----------------------------------------------------------------------------------------


def _declared_numbers(item: Interface, name: str, part: Part) -> tuple[Fraction, ...] | None:
    """A start value or default, one number for each element; None if there is none."""
    given = json_of(getattr(item, f"{name}_elements", None))
    if given is None and _is_only_default(item, name, part):
        return None
    if given is None and not part.keys:
        given = getattr(item, "init_value" if name == "init" else "default")
    found = [_element(_at(given, part.path, index), part) for index in range(part.length or 1)]
    numbers = [number for number in found if number is not None]
    return tuple(numbers) if len(numbers) == len(found) else None


def _is_only_default(item: Interface, name: str, part: Part) -> bool:
    """Whether the start value of an array is no more than what Function JSON requires, and its elements are the default."""
    is_array = isinstance(item, ParameterInterface) and part.length is not None
    return is_array and name == "init" and getattr(item, "default_text", None) is not None


def _at(given: Any, path: Iterable[str | None], index: int) -> Any:
    """Value of an element. A list that is too short repeats its last value; one value is for all elements."""
    for key in path:
        if isinstance(given, list) and key is None:
            given = given[min(index, len(given) - 1)] if given else None
        elif key is not None:
            given = given.get(key) if isinstance(given, Mapping) else None
    return given


def _element(given: Any, part: Part) -> Fraction | None:
    if isinstance(given, str):
        return next((Fraction(each.value) for each in part.symbols or () if each.symbol == given), None)
    if isinstance(given, bool):
        return Fraction(int(given))
    return Fraction(repr(given)) if isinstance(given, int | float) else None


def _target_numbers(given: tuple[Fraction, ...] | None, part: Part, target: Side) -> tuple[Number, ...]:
    """Physical values as the target holds them: 0 where nothing is given."""
    if given is None:
        return (0,) * (part.length or 1)
    if part.symbols is None:
        return tuple(brought_to(target.of(number), target.type) for number in given)
    names = _names(Side(part.type, part.symbols, IDENTITY), target) or {}
    return tuple(names.get(int(number), 0) for number in given)


def _replacement(
    item: Interface, init: tuple[Fraction, ...] | None, default: tuple[Fraction, ...] | None, part: Part, target: Side
) -> tuple[Number, ...] | None:
    if item.range_error_action is None:
        return None
    first, second = (default, init) if item.range_error_action == "Default" else (init, default)
    return _target_numbers(first or second, part, target)


def _wire_type(
    item: Interface, parts: tuple[Part, ...], leaves: tuple[Leaf, ...], context: Context, *, to_code: bool
) -> WireType:
    if any(part.keys for part in parts):
        datatype = context.datatypes[item.datatype]
        length = datatype.length if datatype.kind == "array" else None
        return WireType(struct_name(item.datatype, context), length, is_struct=True)
    element = leaves[0].element
    numbers = item.vss_symbols or parts[0].symbols or ()
    symbols = tuple((each.symbol, each.value) for each in numbers) if parts[0].symbols else ()
    return WireType((element.source if to_code else element.target).c, parts[0].length, symbols=symbols)


def struct_name(reference: str, context: Context) -> str:
    """Name of the struct, as it is received and sent."""
    datatype = context.datatypes[reference]
    inner = datatype.element if datatype.kind == "array" and datatype.element else reference
    return f"{identifier(context.name)}_Adapter_{identifier(inner.removeprefix('DT_'))}"
