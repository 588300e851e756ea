"""Shapes of values, and their numbers one after the other, as two programs exchange them."""

import struct
from collections.abc import Iterator
from typing import Any, NamedTuple

from sigcat.catalogue.model.datatypes import INTEGER_RANGES

_CODES = {
    "boolean": "?", "uint8": "B", "int8": "b", "uint16": "H", "int16": "h", "uint32": "I", "int32": "i", "uint64": "Q",
    "int64": "q", "float": "f", "double": "d",
    "seconds": "Q",
}  # fmt: skip


class Number(NamedTuple):
    """A number of a VSS datatype; of an enumeration with its symbols."""

    datatype: str
    symbols: tuple[tuple[str, int], ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether it holds whole numbers only."""
        return self.datatype in INTEGER_RANGES


class Array(NamedTuple):
    """As many values as its length."""

    element: "Shape"
    length: int


class Record(NamedTuple):
    """A struct."""

    fields: tuple[tuple[str, "Shape"], ...]


Shape = Number | Array | Record
SECONDS = Number("seconds")
"""A time: in seconds in a cell, in nanoseconds everywhere else."""
ERROR_CODE = Number("error code")
"""A code of end-to-end protection: 51, or 0x33."""
Value = Any
"""A number (of an enumeration too), a boolean, a list, or a dict by names of fields."""


class Packing(NamedTuple):
    """A shape, and the layout of its numbers in memory: one after the other, without gaps, as this machine has them."""

    shape: Shape
    struct: struct.Struct

    def pack(self, value: Value) -> bytes:
        """The bytes of a value that has this shape. Raises OverflowError if it is finite and a float cannot hold it."""
        if isinstance(self.shape, Number):
            return self.struct.pack(value)
        return self.struct.pack(*numbers(value, self.shape))

    def unpack(self, data: bytes, offset: int = 0) -> Value:
        """The value of bytes."""
        found = self.struct.unpack_from(data, offset)
        return found[0] if isinstance(self.shape, Number) else built(iter(found), self.shape)


def packing(shape: Shape) -> Packing:
    """Return the packing of values of a shape."""
    return Packing(shape, struct.Struct(f"={_format(shape)}"))


def _format(shape: Shape) -> str:
    if isinstance(shape, Number):
        return _CODES[shape.datatype]
    if isinstance(shape, Array):
        inner = _format(shape.element)
        return f"{shape.length}{inner}" if len(inner) == 1 else inner * shape.length
    return "".join(_format(field) for _, field in shape.fields)


def numbers(value: Value, shape: Shape) -> Iterator[Value]:
    """The numbers of a value, in order."""
    if isinstance(shape, Number):
        yield value
    elif isinstance(shape, Array) and isinstance(shape.element, Number):
        yield from value
    elif isinstance(shape, Array):
        for element in value:
            yield from numbers(element, shape.element)
    else:
        for name, field in shape.fields:
            yield from numbers(value[name], field)


def built(found: Iterator[Value], shape: Shape) -> Value:
    """A value of its numbers."""
    if isinstance(shape, Number):
        return next(found)
    if isinstance(shape, Array):
        return [built(found, shape.element) for _ in range(shape.length)]
    return {name: built(found, field) for name, field in shape.fields}
