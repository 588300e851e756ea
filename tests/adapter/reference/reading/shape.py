"""Datatypes, taken apart: the numbers that a value is made of, in order."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue
from sigcat.function.function_json.datatypes.primitive_types import c_type
from tests.adapter.reference.reading.scale import exact
from tests.adapter.reference.values.number_format import NumberFormat

_DEEPEST = 16


class Unsupported(ValueError):
    """An adapter cannot carry this."""


@dataclass(frozen=True)
class Leaf:
    """A number within a value."""

    format: NumberFormat
    symbols: Mapping[str, int] | None = None
    """Names and numbers, of an enumeration."""
    path: tuple[str | int, ...] = ()
    """Members and indexes that lead to it."""
    least: Fraction | None = None
    """Limits of the member."""
    greatest: Fraction | None = None


@dataclass(frozen=True)
class Shape:
    """A datatype."""

    leaves: tuple[Leaf, ...]
    kind: str | None
    """`array` or `struct`; None for a number."""

    @property
    def has_members(self) -> bool:
        """Whether it is a struct, or an array of structs."""
        return any(isinstance(key, str) for leaf in self.leaves for key in leaf.path)


def shape_of(reference: str, table: Mapping[str, Datatype]) -> Shape:
    """Return the target of a reference."""
    datatype = _datatype(reference, table)
    is_deep = datatype.kind in ("array", "struct")
    return Shape(tuple(_leaves(datatype, table, _DEEPEST)), datatype.kind if is_deep else None)


def _datatype(reference: str, table: Mapping[str, Datatype]) -> Datatype:
    if reference not in table:
        raise Unsupported(f"The datatype {reference} must be one of the document.")
    return table[reference]


def _leaves(datatype: Datatype, table: Mapping[str, Datatype], depth: int) -> Iterator[Leaf]:
    if depth == 0:
        raise Unsupported(f"{datatype.reference} must not be so deep.")
    if datatype.kind == "array":
        yield from _elements(datatype, table, depth)
    elif datatype.kind == "struct":
        yield from _members(datatype, table, depth)
    else:
        yield Leaf(format_of(datatype), numbers_by_name(datatype.symbols))


def _elements(datatype: Datatype, table: Mapping[str, Datatype], depth: int) -> Iterator[Leaf]:
    if datatype.length is None:
        raise Unsupported(f"The array {datatype.reference} must have a length.")
    element = list(_leaves(_datatype(datatype.element or "", table), table, depth - 1))
    for index in range(datatype.length):
        yield from (replace(leaf, path=(index, *leaf.path)) for leaf in element)


def _members(datatype: Datatype, table: Mapping[str, Datatype], depth: int) -> Iterator[Leaf]:
    for field in datatype.fields or ():
        low, high = exact(field.min), exact(field.max)
        for leaf in _leaves(_datatype(field.datatype, table), table, depth - 1):
            least = low if leaf.least is None else leaf.least
            greatest = high if leaf.greatest is None else leaf.greatest
            yield replace(leaf, path=(field.name, *leaf.path), least=least, greatest=greatest)


def numbers_by_name(symbols: tuple[EnumerationValue, ...] | None) -> Mapping[str, int] | None:
    """An enumeration; None if there is none."""
    return {each.symbol: each.value for each in symbols} if symbols else None


def format_of(datatype: Datatype) -> NumberFormat:
    """The format of a primitive datatype, by its definition in C."""
    meant = c_type(datatype.c_definition)
    if meant is None or meant.kind == "text" or (meant.kind != "boolean" and meant.bits == 0):
        raise Unsupported(f"{datatype.reference} must be a number of a fixed size, not {datatype.c_definition!r}.")
    if meant.kind == "boolean":
        return NumberFormat("boolean")
    if meant.kind == "floating":
        return NumberFormat("float" if meant.bits == 32 else "double")
    return NumberFormat(f"{'u' if meant.kind == 'unsigned' else ''}int{meant.bits}")
