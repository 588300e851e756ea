"""Transfer of values from the catalogue to the code and back: formats, scales, limits and substitutes of an interface."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import Argument
from tests.adapter.reference.reading.given_values import Given, given_values
from tests.adapter.reference.reading.scale import Scale, exact, scale, shortest
from tests.adapter.reference.reading.shape import Leaf, Shape, Unsupported, numbers_by_name, shape_of
from tests.adapter.reference.values.number_format import Number, NumberFormat
from tests.adapter.reference.values.transfer import Element, Transfer

Interface = Signal | DataQueue | ParameterInterface
Table = Mapping[str, Datatype]
"""Datatypes by their references."""


@dataclass(frozen=True)
class Side:
    """A number of the value as one side has it: the code, or the catalogue."""

    format: NumberFormat
    symbols: Mapping[str, int] | None
    scale: Scale
    """From the physical value to the one of this side."""
    is_catalogue: bool = False

    def of_physical(self, number: Fraction) -> Fraction:
        """A number that the document has, on this side."""
        return shortest(number, self.scale) if self.is_catalogue else self.scale.forward(number)


def to_code(interface: Interface, table: Table) -> Transfer:
    """From what is received to the variable."""
    return _transfer(interface, table, is_sent=False)


def to_catalogue(interface: Interface, table: Table) -> Transfer:
    """From the variable to what is sent."""
    return _transfer(interface, table, is_sent=True)


def unchanged(argument: Argument, table: Table) -> Transfer:
    """An argument or result of a method, which both sides have alike."""
    shape = shape_of(argument.datatype, table)
    elements = [Element(leaf.format, leaf.format, names=_same(leaf.symbols)) for leaf in shape.leaves]
    return Transfer(tuple(elements), is_single=shape.kind is None)


def _same(symbols: Mapping[str, int] | None) -> dict[int, int] | None:
    return None if symbols is None else {number: number for number in symbols.values()}


def _transfer(interface: Interface, table: Table, *, is_sent: bool) -> Transfer:
    shape = shape_of(interface.datatype, table)
    init, default = _given(interface, shape)
    elements = []
    for leaf, first, second in zip(shape.leaves, init, default, strict=True):
        code, catalogue = _code(interface, leaf, shape), _catalogue(interface, leaf, shape)
        source, target = (code, catalogue) if is_sent else (catalogue, code)
        elements.append(_element(interface, leaf, shape, source, target, first, second))
    action = interface.range_error_action
    return Transfer(tuple(elements), shape.kind is None, action if action in ("Default", "Init") else None)


def _element(
    interface: Interface, leaf: Leaf, shape: Shape, source: Side, target: Side, init: Fraction | None, default: Fraction | None
) -> Element:  # fmt: skip
    names = _names(source, target)
    way = Scale() if names is not None else _way(source, target)
    if not way.is_identity and (source.format.is_wide or target.format.is_wide):
        raise Unsupported(f"{interface.name} must not convert a 64-bit integer.")
    least, greatest = _limits(interface, leaf, shape, source)
    return Element(
        source.format,
        target.format,
        way.factor,
        way.offset,
        names,
        least,
        greatest,
        is_checked=bool(interface.range_error_action or interface.range_error),
        init=_held(default if init is None else init, leaf, target),
        default=_held(init if default is None else default, leaf, target),
    )


# -- sides --------------------------------------------------------------------------------------------------------


def _code(interface: Interface, leaf: Leaf, shape: Shape) -> Side:
    if shape.has_members:
        return Side(leaf.format, leaf.symbols, Scale())
    stored = scale(interface.factor, interface.offset)
    return Side(leaf.format, leaf.symbols, Scale(1 / stored.factor, -stored.offset / stored.factor))


def _catalogue(interface: Interface, leaf: Leaf, shape: Shape) -> Side:
    if shape.has_members or interface.vss_datatype is None:
        return _code(interface, leaf, shape)
    conversion = scale(interface.conversion_factor, interface.conversion_offset)
    name = interface.vss_datatype.removesuffix("[]")
    symbols = None if leaf.symbols is None else numbers_by_name(interface.vss_symbols) or leaf.symbols
    if symbols is not None and name not in INTEGER_RANGES:
        name = _smallest(symbols)
    known = name in INTEGER_RANGES or name in ("boolean", "float", "double")
    return Side(NumberFormat(name) if known else leaf.format, symbols, conversion, is_catalogue=True)


def _smallest(symbols: Mapping[str, int]) -> str:
    """The smallest integer that holds all numbers; of two, the one without a sign."""
    for bits in (8, 16, 32, 64):
        for name in (f"uint{bits}", f"int{bits}"):
            low, high = INTEGER_RANGES[name]
            if all(low <= number <= high for number in symbols.values()):
                return name
    raise Unsupported("An enumeration must fit 64 bits.")


def _way(source: Side, target: Side) -> Scale:
    """From the number of one side to that of the other."""
    factor = target.scale.factor / source.scale.factor
    return Scale(factor, target.scale.offset - source.scale.offset * factor)


def _names(source: Side, target: Side) -> dict[int, int] | None:
    if source.symbols is None or target.symbols is None:
        return None
    common = [name for name in source.symbols if name in target.symbols]
    return {source.symbols[name]: target.symbols[name] for name in reversed(common)}


# -- limits and substitutes ---------------------------------------------------------------------------------------


def _limits(
    interface: Interface, leaf: Leaf, shape: Shape, source: Side
) -> tuple[Fraction | None, Fraction | None]:  # fmt: skip
    low, high = (leaf.least, leaf.greatest) if shape.has_members else (exact(interface.min), exact(interface.max))
    if isinstance(interface, ParameterInterface) and shape.kind is not None and low == high == 0:
        return None, None
    ends = [None if end is None else source.of_physical(end) for end in (low, high)]
    low, high = ends if source.scale.factor > 0 else reversed(ends)
    if source.format.is_floating:
        return _nearest(low, source), _nearest(high, source)
    least = None if low is None else Fraction(math.ceil(low))
    return least, None if high is None else Fraction(math.floor(high))


def _nearest(limit: Fraction | None, source: Side) -> Fraction | None:
    return None if limit is None else Fraction(source.format.nearest(limit))


def _given(interface: Interface, shape: Shape) -> tuple[Given, Given]:
    """Start value and default."""
    init = given_values(interface.init_value, interface.init_elements, shape)
    default = given_values(interface.default, interface.default_elements, shape)
    has_elements = shape.kind is not None and interface.default_elements is not None and not interface.init_elements
    return (default if has_elements and isinstance(interface, ParameterInterface) else init), default


def _held(number: Fraction | None, leaf: Leaf, side: Side) -> Number:
    """A physical value as a side holds it; 0 if there is none."""
    if number is None:
        return 0.0 if side.format.is_floating else 0
    if leaf.symbols is None or side.symbols is None:
        return side.format.nearest(side.of_physical(number))
    named = next((name for name, value in leaf.symbols.items() if value == number), "")
    return side.symbols.get(named, 0)
