"""A statement: what one file says about one node, with the position of every value.

Each position is packed into one integer: a tree of 100,000 signals has half a million attributes, and positions are
needed only when something is shown.
"""

from array import array
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node

from sigcat.catalogue.reading.yaml_document import merged_pairs

_MARKS = "Q"
_COLUMN_BITS = 12
_LINES_BETWEEN_BITS = 12
_MOST_COLUMNS = (1 << _COLUMN_BITS) - 1
_MOST_LINES = (1 << _LINES_BETWEEN_BITS) - 1


class Origin(NamedTuple):
    """Where a value was written: file, line and column (from 1), and the overlay, if it is in one."""

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
    """What one file says about one node: its key and the attributes under it, in the order of the file.

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
        mark = self._mark(attribute)
        line_of_key, _, lines_between, column = unpacked_mark(mark)
        return Origin(self.file.name, line_of_key + lines_between + 1, column + 1, self.file.overlay)

    def origin_of_key(self, attribute: str) -> Origin:
        """Position of the name of an attribute."""
        line, column, _, _ = unpacked_mark(self._mark(attribute))
        return Origin(self.file.name, line + 1, column + 1, self.file.overlay)

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin | None:
        """Position of an item of a list (by index) or of a mapping (by key, or by index), or of its key.

        None if nothing is written there, as where a list is merged from elsewhere.
        """
        names = list(self.values)
        mark, at, value = 0, len(names), self.values.get(attribute)
        if value is not None:
            at += sum(_items_in(self.values[name]) for name in names[: names.index(attribute)])
        for step in steps:
            found = _item(value, step)
            if found is None or at + found.before >= len(self._marks):
                return None
            at, value = at + found.before + 1, found.value
            mark = self._marks[at - 1]
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

    def _mark(self, attribute: str) -> int:
        if attribute in self.values:
            return self._marks[list(self.values).index(attribute)]
        return self._key_mark


class _Item(NamedTuple):
    """An item of a list or mapping, and how many items are before it, those inside them included."""

    before: int
    value: Any


def _item(value: Any, step: int | str) -> _Item | None:
    """The item at a position, or under a key."""
    keys = list(map(str, value)) if isinstance(value, dict) else []
    items = list(value.values()) if isinstance(value, dict) else value if isinstance(value, list) else []
    index = step if isinstance(step, int) else keys.index(step) if step in keys else len(items)
    if index >= len(items):
        return None
    is_flat = {dict, list}.isdisjoint(map(type, items[:index]))  # most are, and some lists have thousands of items
    return _Item(index if is_flat else index + sum(map(_items_in, items[:index])), items[index])


def _items_in(value: Any) -> int:
    """How many items a value has, with all that is in them."""
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


def marks_of_items(node: Node, value: Any) -> Iterator[int]:
    """Packed positions of the items of a value, each before those of what is in it; 0 where a key is given twice."""
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
