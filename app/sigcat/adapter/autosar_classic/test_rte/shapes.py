"""Shapes of values as tables: the place of each number, and the text before it."""

import json
from collections.abc import Mapping
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.plan import RteType
from sigcat.adapter.autosar_classic.code.rte_headers.literals import number


class _Number(NamedTuple):
    before: str
    base: str
    offset: str
    symbols: str


Symbols = tuple[tuple[str, int], ...]


class Shape(NamedTuple):
    """A type, and the names of its numbers: those of an enumeration, or by the names of the types within."""

    name: str
    type: RteType
    named: Mapping[str, Symbols]
    symbols: Symbols = ()

    def numbers(self) -> tuple[list[_Number], str]:
        """Numbers, and the text after the last one."""
        return self._of(self.type, "", "0U")

    def tables(self) -> Mapping[str, Symbols]:
        """Tables of symbols that its numbers use."""
        return {each.symbols: self.symbols or self.named[each.symbols] for each in self.numbers()[0] if each.symbols}

    def _of(self, type_: RteType, before: str, offset: str) -> tuple[list[_Number], str]:
        if type_.element is not None:
            return self._elements(type_.element, type_.length, before, offset)
        if type_.members:
            return self._members(type_, before, offset)
        symbols = self.name if self.symbols else type_.name if type_.name in self.named else ""
        return [_Number(before, type_.base, offset, symbols)], ""

    def _elements(self, element: RteType, length: int, before: str, offset: str) -> tuple[list[_Number], str]:
        found: list[_Number] = []
        text = f"{before}["
        for index in range(length):
            numbers, text = self._of(element, text, f"{offset} + ({index}U * sizeof({element.name}))")
            found += numbers
            text += "," if index < length - 1 else "]"
        return found, text

    def _members(self, type_: RteType, before: str, offset: str) -> tuple[list[_Number], str]:
        found: list[_Number] = []
        text = f"{before}{{"
        for index, (name, inner) in enumerate(type_.members):
            numbers, text = self._of(inner, f"{text}{json.dumps(name)}:", f"{offset} + offsetof({type_.name}, {name})")
            found += numbers
            text += "," if index < len(type_.members) - 1 else "}"
        return found, text


def initializer(value: object, type_: RteType) -> str:
    """A constant of C for a value of the document; one number applies to every element and every member."""
    if type_.element is not None:
        items = value if isinstance(value, list | tuple) else [value] * type_.length
        return "{" + ", ".join(initializer(each, type_.element) for each in items) + "}"
    if type_.members:
        given = value if isinstance(value, Mapping) else dict.fromkeys((name for name, _ in type_.members), value)
        return "{" + ", ".join(initializer(given[name], inner) for name, inner in type_.members) + "}"
    return number(value if isinstance(value, int | float) else 0, type_.base)
