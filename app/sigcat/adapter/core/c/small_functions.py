"""The small functions of C that conversions and errors need. A source has those that it uses."""

import re
from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

from sigcat.adapter.core.c.lines import Lines, code_of, lines
from sigcat.adapter.core.c.literals import literal
from sigcat.adapter.core.numbers import NumberType, number_type
from sigcat.adapter.templates import rendered
from sigcat.catalogue.model.datatypes import INTEGER_RANGES


class _Integer(NamedTuple):
    """An integer type, with its limits as numbers, as its literals and as literals of doubles."""

    name: str
    c: str
    smallest: int
    largest: int
    least: str
    most: str
    least_double: str
    most_double: str
    is_widest: bool


class _Plan(NamedTuple):
    p: str
    m: str
    integers: Sequence[_Integer]


def used_functions(text: str, prefix: str, macro: str) -> list[Lines]:
    """Return functions that a text calls, and those that they call, each before its first use."""
    wanted: list[Lines] = []
    for name, part in reversed(_every_function(prefix, macro)):
        if any(f"{prefix}_{name}(" in each for each in (text, *map(code_of, wanted))):
            wanted.append(part)
    return wanted[::-1]


@cache
def _integers() -> tuple[_Integer, ...]:
    return tuple(_integer(found) for name in INTEGER_RANGES if (found := number_type(name)))


def _integer(of: NumberType) -> _Integer:
    low, high = int(of.smallest), int(of.largest)
    ends = literal(low, of), literal(high, of), repr(float(low)), repr(float(high))
    return _Integer(of.name.capitalize(), of.c, low, high, *ends, is_widest=of.name == "uint64")


def _every_function(prefix: str, macro: str) -> list[tuple[str, Lines]]:
    """All by name, each after those that it calls."""
    text = rendered("adapter/core/c/small_functions.c.j2", _Plan(prefix, macro, _integers()))
    name = re.compile(rf"\b{prefix}_(\w+)\(")
    parts = re.split(r"(?<=^}\n)\n", text, flags=re.MULTILINE)
    return [(found[1], lines(part)) for part in parts if (found := name.search(part))]
