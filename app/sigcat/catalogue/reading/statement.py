"""A statement: what one file says about one node, with the position of every value.

Each position is packed into one integer: a tree of 100,000 signals has half a million attributes, and positions are
needed only when something is shown.
"""

from array import array
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import accumulate, takewhile
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node

from sigcat.catalogue.reading.yaml_document import merged_pairs

_MARKS = "Q"
_COLUMN_BITS = 12
_LINES_BETWEEN_BITS = 12
_MOST_COLUMNS = (1 << _COLUMN_BITS) - 1
_MOST_LINES = (1 << _LINES_BETWEEN_BITS) - 1


class Origin(NamedTuple):
    """Place of a value: file, line and column (from 1), and the overlay, if it is in one."""

    file: str
    line: int
    column: int
    overlay: str = ""

    @property
    def position(self) -> tuple[str, int, int]:
        """File, line and column, in the order in which a finding takes them."""
        return self.file, self.line, self.column


class SourceFile(NamedTuple):
    """A file that was read. `overlay` is the name of the overlay it belongs to, empty in the base tree."""

    name: str
    overlay: str
    digest: str
    """SHA-256 of the bytes, in hexadecimal."""


class Statement:
    """Statement of one file about one node: its key and the attributes under it, in the order of the file.

    Its marks are packed positions: first those of the attributes, aligned with `values`, then those of the items of
    lists and mappings.
    """

    __slots__ = ("_key_mark", "_marks", "file", "path", "values")

    def __init__(
        self, path: str, file: SourceFile, values: Mapping[str, Any], key_mark: int, marks: Sequence[int]
    ) -> None:
        self.path = path
        self.file = file
        self.values = values
        self._key_mark = key_mark
        self._marks = marks

    def __repr__(self) -> str:
        origin = self.origin()
        return f"<Statement {self.path} {origin.file}:{origin.line}>"

    def origin(self, attribute: str = "") -> Origin:
        """Position of the value of `attribute`; of the node's key if the attribute is empty or not here."""
        return Origin(self.file.name, *_value_position(self._mark(attribute)), self.file.overlay)

    def value_positions(self) -> Iterator[tuple[str, int, int]]:
        """Each attribute with the line and the column of its value."""
        if not self._marks:  # a subclass knows the positions
            yield from ((name, *self.origin(name)[1:3]) for name in self.values)
        for name, mark in zip(self.values, self._marks, strict=False):
            yield name, *_value_position(mark)

    def origin_of_key(self, attribute: str) -> Origin:
        """Position of the name of an attribute."""
        line, column, _, _ = unpacked_mark(self._mark(attribute))
        return Origin(self.file.name, line + 1, column + 1, self.file.overlay)

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin | None:
        """Position of an item of a list (by index) or of a mapping (by key, or by index), or of its key.

        None if nothing is written there, as where a list is merged from elsewhere.
        """
        items = _items_within(self, attribute, tuple(steps[:-1])) if steps else None
        mark = self._mark_at(items.place(steps[-1])) if items is not None else 0
        if not mark:
            return None
        line, column, lines_between, column_of_value = unpacked_mark(mark)
        line, column = (line, column) if at_key else (line + lines_between, column_of_value)
        return Origin(self.file.name, line + 1, column + 1, self.file.overlay)

    def spelled(self, attribute: str) -> str:
        """The key under which its file has an attribute, or would have it."""
        return attribute

    def packed(self) -> tuple[str, Mapping[str, Any], int, bytes]:
        """All but the file, in types that marshal knows."""
        return self.path, self.values, self._key_mark, array(_MARKS, self._marks).tobytes()

    @classmethod
    def unpacked(
        cls, file: SourceFile, path: str, values: Mapping[str, Any], key_mark: int, marks: bytes
    ) -> "Statement":
        """A statement that was packed."""
        return cls(path, file, values, key_mark, array(_MARKS, marks))

    def placed(self, prefix: str) -> "Statement":
        """The same statement below `prefix`, for an include with a prefix."""
        return Statement(f"{prefix}.{self.path}", self.file, self.values, self._key_mark, self._marks)

    def with_values(self, values: Mapping[str, Any]) -> "Statement":
        """The same statement with other names or values of its attributes, in the same order and at the same positions."""
        return Statement(self.path, self.file, values, self._key_mark, self._marks)

    def _mark_at(self, place: int | None) -> int:
        """The mark of an item, or 0."""
        return self._marks[place] if place is not None and place < len(self._marks) else 0

    def _mark(self, attribute: str) -> int:
        place = _places_of(self).get(attribute) if attribute else None
        return self._key_mark if place is None else self._marks[place]


@lru_cache(maxsize=8)
def _places_of(statement: Statement) -> Mapping[str, int]:
    """Return the index of the mark of each attribute. Cached for the same reason as `_items_within`."""
    return {name: place for place, name in enumerate(statement.values)}


class _Items(NamedTuple):
    """The items of a list or mapping, and where their marks are."""

    values: Sequence[Any]
    keys: Mapping[str, int]
    """Indexes of the items of a mapping, by key."""
    places: Sequence[int]
    """Index of the mark of each item; those of the items within it follow."""

    def position(self, step: int | str) -> int | None:
        """The item at a position, or under a key, if there is one."""
        index = step if isinstance(step, int) else self.keys.get(step, len(self.values))
        return index if index < len(self.values) else None

    def place(self, step: int | str) -> int | None:
        """Return the index of the item's mark, or None."""
        index = self.position(step)
        return None if index is None else self.places[index]


@lru_cache(maxsize=8)
def _items_within(statement: Statement, attribute: str, steps: tuple[int | str, ...]) -> _Items | None:
    """The items of an attribute, or of an item of it; None if there is no such item.

    Kept, as findings of the same list of thousands of items come one after the other.
    """
    if not steps:
        before = takewhile(lambda name: name != attribute, statement.values)
        first = len(statement.values) + sum(_items_in(statement.values[name]) for name in before)
        return _items_of(statement.values.get(attribute), first)
    around = _items_within(statement, attribute, steps[:-1])
    index = around and around.position(steps[-1])
    return None if around is None or index is None else _items_of(around.values[index], around.places[index] + 1)


def _items_of(value: Any, first: int) -> _Items:
    keys = {str(key): index for index, key in reversed(list(enumerate(value)))} if isinstance(value, dict) else {}
    values = list(value.values()) if isinstance(value, dict) else value if isinstance(value, list) else []
    sizes = (1 + _items_in(each) for each in values[:-1])
    return _Items(values, keys, list(accumulate(sizes, initial=first)))


def _items_in(value: Any) -> int:
    """Return the number of items of a value, with all items in them."""
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return sum(1 + _items_in(item) for item in items)


# -- packed positions ---------------------------------------------------------------------------------------------


def mark_of(key: Any, value: Any) -> int:
    """Positions of a key and of its value in one integer of 64 bits; what does not fit is cut."""
    line: int = key.line
    column: int = key.column
    lines_between: int = value.line - line
    value_column: int = value.column
    if column > _MOST_COLUMNS or value_column > _MOST_COLUMNS or not 0 <= lines_between <= _MOST_LINES:
        column, value_column = min(column, _MOST_COLUMNS), min(value_column, _MOST_COLUMNS)
        lines_between = min(max(lines_between, 0), _MOST_LINES)
    return line << _LINE | column << _COLUMN | lines_between << _COLUMN_BITS | value_column


_COLUMN = _LINES_BETWEEN_BITS + _COLUMN_BITS
_LINE = _COLUMN_BITS + _COLUMN


def unpacked_mark(mark: int) -> tuple[int, int, int, int]:
    value_column = mark & _MOST_COLUMNS
    mark >>= _COLUMN_BITS
    lines_between = mark & _MOST_LINES
    mark >>= _LINES_BETWEEN_BITS
    return mark >> _COLUMN_BITS, mark & _MOST_COLUMNS, lines_between, value_column


def _value_position(mark: int) -> tuple[int, int]:
    """Line and column of the value, from 1."""
    return (mark >> _LINE) + (mark >> _COLUMN_BITS & _MOST_LINES) + 1, (mark & _MOST_COLUMNS) + 1


def marks_of_items(node: Node, value: Any) -> Iterator[int]:
    """Packed positions of the items of a value, each before those of its contents; 0 where a key is given twice."""
    if isinstance(value, list):
        pairs = [(item, item) for item in node.value]
    elif isinstance(value, dict) and isinstance(node, MappingNode):
        pairs = merged_pairs(node)
    else:
        return
    if len(pairs) != len(value):
        yield from (0 for _ in range(_items_in(value)))
        return
    for (key, item), inner in zip(pairs, value.values() if isinstance(value, dict) else value, strict=True):
        yield mark_of(key.start_mark, item.start_mark)
        yield from marks_of_items(item, inner)
