"""Scripts: what a platform does with an adapter, line by line. Any part of a script is a script."""

import math
import struct
from collections.abc import Sequence

from tests.adapter.core.subject import Leaf
from tests.adapter.reference.values.number_format import Number, NumberFormat
from tests.adapter.reference.values.value import Value, numbers_of

Line = tuple[str | int, ...]
"""A word, and what belongs to it: numbers, and values as the bits of their numbers."""
Script = list[Line]

_SIZES = {"uint8": 1, "int8": 1, "boolean": 1, "uint16": 2, "int16": 2, "uint32": 4, "int32": 4, "float": 4}


def size(format_: NumberFormat) -> int:
    """Bytes of a number."""
    return _SIZES.get(format_.name, 8)


def bits(number: Number, format_: NumberFormat) -> str:
    """A number as its bits. A NaN is the one that is sent."""
    length = size(format_)
    if not format_.is_floating:
        return f"{int(number) % 256**length:0{2 * length}x}"
    if math.isnan(number):
        return "7fc00000" if length == 4 else "7ff8000000000000"
    return struct.pack(">f" if length == 4 else ">d", number).hex()


def number(text: str, format_: NumberFormat) -> Number:
    """The number that has these bits."""
    if format_.is_floating:
        return float(struct.unpack(">f" if size(format_) == 4 else ">d", bytes.fromhex(text))[0])
    return int.from_bytes(bytes.fromhex(text), signed=format_.name.startswith("int"))


def value(text: str, leaves: Sequence[Leaf], *, is_single: bool) -> Value:
    """The value whose numbers have these bits."""
    numbers, start = [], 0
    for leaf in leaves:
        end = start + 2 * size(leaf.format)
        numbers.append(number(text[start:end], leaf.format))
        start = end
    return numbers[0] if is_single else tuple(numbers)


def text(given: Value, leaves: Sequence[Leaf]) -> str:
    """A value as the bits of its numbers."""
    return "".join(bits(each, leaf.format) for each, leaf in zip(numbers_of(given), leaves, strict=True))


def written(script: Script) -> str:
    """A script as the program reads it."""
    return "".join(" ".join(map(str, line)) + "\n" for line in script)
