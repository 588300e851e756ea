"""Shapes of values as tables: where each number is, and what stands before it in a text."""

import json
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.literals import number
from sigcat.adapter.autosar_classic.code.plan import RteType
from sigcat.adapter.core.c.lines import Lines, block, joined, lines
from sigcat.adapter.text_filters import c_string


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
        """Numbers, and what stands after the last one."""
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


def shape_tables(shapes: Sequence[Shape]) -> list[Lines]:
    """A table for each shape, which is called `TestRte_Shape_<name>`, and before them the symbols."""
    symbols = {name: table for each in shapes for name, table in each.tables().items()}
    return [*(_symbols(name, table) for name, table in symbols.items()), *(_shape(each) for each in shapes)]


def _symbols(name: str, symbols: Symbols) -> Lines:
    rows = [lines(f"{{{c_string(text)}, {number}}},") for text, number in symbols]
    return block(f"static const TestRte_Symbol symbols_{name}[] =", [*rows, lines("{NULL, 0}")], "};")


def _shape(shape: Shape) -> Lines:
    numbers, after = shape.numbers()
    rows = [
        lines(f"{{{c_string(each.before)}, TEST_RTE_{each.base.upper()}, (uint32)({each.offset}), "
              f"{f'symbols_{each.symbols}' if each.symbols else 'NULL'}}},")
        for each in numbers
    ]  # fmt: skip
    whole = f"{{sizeof({shape.type.name}), {len(numbers)}U, numbers_{shape.name}, {c_string(after)}}}"
    return joined([
        block(f"static const TestRte_Number numbers_{shape.name}[] =", rows, "};"),
        lines(f"const TestRte_Shape TestRte_Shape_{shape.name} = {whole};"),
    ])  # fmt: skip


def initializer(value: object, type_: RteType) -> str:
    """A constant of C for a value of the document; one number stands for every element and every member."""
    if type_.element is not None:
        items = value if isinstance(value, list | tuple) else [value] * type_.length
        return "{" + ", ".join(initializer(each, type_.element) for each in items) + "}"
    if type_.members:
        given = value if isinstance(value, Mapping) else dict.fromkeys((name for name, _ in type_.members), value)
        return "{" + ", ".join(initializer(given[name], inner) for name, inner in type_.members) + "}"
    return number(value if isinstance(value, int | float) else 0, type_.base)
