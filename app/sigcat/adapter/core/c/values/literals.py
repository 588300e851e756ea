"""Numbers as literals of C."""

import struct

from sigcat.adapter.core.numbers import Number, NumberType

_SMALLEST = {-(2**31): "INT32_MIN", -(2**63): "INT64_MIN"}


def literal(number: Number, of: NumberType) -> str:
    """A number as a literal of its type."""
    if of.is_boolean:
        return "true" if number else "false"
    if of.is_floating:
        return f"{_shortest_float(number)}F" if of.name == "float" else repr(float(number))
    return _integer(int(number), of)


def _integer(number: int, of: NumberType) -> str:
    if of.is_wide:
        return _SMALLEST.get(number) or f"{'U' if of.name == 'uint64' else ''}INT64_C({number})"
    return _SMALLEST.get(number) or f"{number}{'U' if of.name.startswith('u') else ''}"


def _shortest_float(number: float) -> str:
    wanted = struct.pack("f", number)
    texts = (f"{number:.{digits}g}" for digits in range(1, 10))
    return repr(float(next((text for text in texts if struct.pack("f", float(text)) == wanted), repr(number))))
