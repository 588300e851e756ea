"""One vspec file: its statements (a path with attributes) and its includes, each with its position.

The vspec language is as vss-tools 6.1 reads it: dotted keys, `#include FILE [PREFIX]`
lines, and `includes:` lists on branches.
"""

import re
import sys
from array import array
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat import codes
from sigcat.catalogue.reading.yaml_document import (
    TEXT,
    Builder,
    Unbuildable,
    duplicate_keys,
    merged_pairs,
    position,
    read_document,
)
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits

_INCLUDE_LINE = re.compile(r"^[ \t]*#include.*$", re.MULTILINE)
_COLUMN_BITS = 12
_LINES_BETWEEN_BITS = 12
_MOST_COLUMNS = (1 << _COLUMN_BITS) - 1
_MOST_LINES = (1 << _LINES_BETWEEN_BITS) - 1


class Origin(NamedTuple):
    """Where a value was written: file, line and column (from 1), and the overlay, if it stands in one."""

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

    Each position is packed into one integer: first those of the attributes, aligned with `values`, then those of the
    items of lists and mappings. A tree of 100,000 signals has half a million attributes, and positions are needed only
    when something is shown.
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
        line_of_key, _, lines_between, column = _unpack(mark)
        return Origin(self.file.name, line_of_key + lines_between + 1, column + 1, self.file.overlay)

    def origin_of_key(self, attribute: str) -> Origin:
        """Position of the name of an attribute."""
        line, column, _, _ = _unpack(self._mark(attribute))
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
        line, column, lines_between, column_of_value = _unpack(mark)
        line, column = (line, column) if at_key else (line + lines_between, column_of_value)
        return Origin(self.file.name, line + 1, column + 1, self.file.overlay)

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


class Include(NamedTuple):
    """A request to read another file, its keys placed below `prefix`."""

    target: str
    prefix: str
    line: int
    column: int


class VspecFile(NamedTuple):
    """The content of one file, before any include is followed."""

    source: SourceFile
    statements: tuple[Statement, ...]
    includes: tuple[Include, ...]
    findings: tuple[Finding, ...]


def parse_vspec(data: bytes, source: SourceFile, limits: Limits = DEFAULT_LIMITS) -> VspecFile:
    """Read the bytes of one vspec file. What is not a statement becomes a finding; the rest is still read."""
    document = read_document(data, source.name, limits)
    findings = list(document.findings)
    statements: list[Statement] = []
    includes: list[Include] = []
    if isinstance(document.root, MappingNode):
        _read_statements(document.root, source, Builder(limits, len(document.text)), statements, includes, findings)
    elif document.root is not None and not _is_null(document.root):
        line, column = position(document.root)
        message = f"The file must be a mapping of node paths to attributes, not {_kind(document.root)}."
        findings.append(codes.NOT_A_MAPPING.finding(message, source.name, line, column))
    includes.extend(_include_lines(document.text, source.name, findings))
    return VspecFile(source, tuple(statements), tuple(includes), tuple(findings))


def _read_statements(
    root: MappingNode,
    source: SourceFile,
    builder: Builder,
    statements: list[Statement],
    includes: list[Include],
    findings: list[Finding],
) -> None:
    _report_duplicates(root, source.name, "Node", "", findings)
    numbers: dict[str, int] = {}
    try:
        pairs = merged_pairs(root)
    except Unbuildable as error:
        findings.append(_unbuildable(error, source.name, ""))
        return
    for key, node in pairs:
        statement = _read_statement(key, node, source, builder, includes, findings)
        if statement is None:
            continue
        if statement.path in numbers:
            statements[numbers[statement.path]] = statement
        else:
            numbers[statement.path] = len(statements)
            statements.append(statement)


def _read_statement(
    key: Node, node: Node, source: SourceFile, builder: Builder, includes: list[Include], findings: list[Finding]
) -> Statement | None:
    try:
        path = builder.key(key)
        if not isinstance(path, str) or not path:
            raise Unbuildable(f"The path of a node must be text, not {path!r}.", key)
        if not isinstance(node, MappingNode):
            raise Unbuildable(
                f"{path!r} must be a mapping of attributes, not {_kind(node)}.", node, codes.NOT_A_MAPPING
            )
        values, marks, collections = _attributes(node, builder)
    except Unbuildable as error:
        findings.append(_unbuildable(error, source.name, key.value if isinstance(key, ScalarNode) else ""))
        return None
    if len(values) != len(node.value):
        _report_duplicates(node, source.name, "Attribute", path, findings)
    includes_at = None
    if "includes" in values and values.get("type") == "branch":
        mark = marks.pop(list(values).index("includes"))
        includes_at = (values.pop("includes"), mark)
    mark = _mark(key.start_mark, key.start_mark)
    for name in filter(collections.__contains__, values):
        marks.extend(_marks_in(collections[name], values[name]))
    statement = Statement(path, source, values, mark, array("Q", marks))
    if includes_at is not None:
        includes.extend(_include_list(statement, *includes_at, findings))
    return statement


def _attributes(node: MappingNode, builder: Builder) -> tuple[dict[str, Any], list[int], dict[str, Node]]:
    """Values by name, the packed position of each in the same order, and the nodes of those that hold others."""
    values: dict[str, Any] = {}
    marks: list[int] = []
    collections: dict[str, Node] = {}
    for key, value in merged_pairs(node):
        name = sys.intern(key.value) if key.tag == TEXT else builder.key(key)
        if not isinstance(name, str):
            raise Unbuildable(f"The name of an attribute must be text, not {name!r}.", key)
        start, end = key.start_mark, value.start_mark
        if name in values:
            marks[list(values).index(name)] = _mark(start, end)
        else:
            marks.append(_mark(start, end))
        if isinstance(value, ScalarNode):
            values[name] = builder.scalar(value)
        else:
            values[name] = builder.value(value)
            collections[name] = value
    return values, marks, collections


class _Item(NamedTuple):
    """An item of a list or mapping, and how many items stand before it, with all that is in them."""

    before: int
    value: Any


def _item(value: Any, step: int | str) -> _Item | None:
    """The item at a position, or under a key."""
    keys = list(map(str, value)) if isinstance(value, dict) else []
    items = list(value.values()) if isinstance(value, dict) else value if isinstance(value, list) else []
    index = step if isinstance(step, int) else keys.index(step) if step in keys else len(items)
    if index >= len(items):
        return None
    return _Item(sum(1 + _items_in(item) for item in items[:index]), items[index])


def _items_in(value: Any) -> int:
    """How many items a value has, with all that is in them."""
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return sum(1 + _items_in(item) for item in items)


def _marks_in(node: Node, value: Any) -> Iterator[int]:
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
        yield _mark(key.start_mark, item.start_mark)
        yield from _marks_in(item, inner)


def _report_duplicates(node: MappingNode, file: str, what: str, path: str, findings: list[Finding]) -> None:
    for key in duplicate_keys(node):
        if key.value == "<<":
            continue
        line, column = position(key)
        message = f"{what} {key.value!r} is given twice; only the last one counts."
        findings.append(
            codes.DUPLICATE_KEY.finding(message, file, line, column, path or key.value, fix="Remove one of the two.")
        )


def _unbuildable(error: Unbuildable, file: str, path: str) -> Finding:
    line, column = position(error.node)
    return error.rule.finding(str(error), file, line, column, path)


def _include_list(statement: Statement, listed: Any, mark: int, findings: list[Finding]) -> Iterator[Include]:
    line, _, lines_between, column = _unpack(mark)
    origin = Origin(statement.file.name, line + lines_between + 1, column + 1)
    entries = listed if isinstance(listed, list) else [listed]
    for entry in entries:
        parts = entry.split() if isinstance(entry, str) and isinstance(listed, list) else []
        if not parts:
            message = "`includes` must be a list of file names."
            findings.append(codes.INCLUDE_MALFORMED.finding(message, *origin.position, statement.path))
            continue
        yield Include(parts[0], statement.path, origin.line, origin.column)


def _include_lines(text: str, file: str, findings: list[Finding]) -> Iterator[Include]:
    if "#include" not in text:
        return
    line, counted = 1, 0
    for match in _INCLUDE_LINE.finditer(text):
        line, counted = line + text.count("\n", counted, match.start()), match.start()
        column = match.group().index("#") + 1
        _, *parts = match.group().split()
        if not parts:
            message = "An include must name a file: `#include FILE [PREFIX]`."
            findings.append(codes.INCLUDE_MALFORMED.finding(message, file, line, column))
            continue
        if len(parts) > 2:
            message = f"An include takes a file and a prefix; {' '.join(parts[1:])!r} is ignored."
            ignored = codes.INCLUDE_MALFORMED.graded("warning")  # the file is read all the same
            findings.append(ignored.finding(message, file, line, column))
        yield Include(parts[0], parts[1] if len(parts) == 2 else "", line, column)


def _kind(node: Node) -> str:
    return "a list" if isinstance(node, SequenceNode) else "a single value"


def _is_null(node: Node) -> bool:
    return isinstance(node, ScalarNode) and node.tag.endswith(":null")


def _mark(key: Any, value: Any) -> int:
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


def _unpack(mark: int) -> tuple[int, int, int, int]:
    value_column = mark & _MOST_COLUMNS
    mark >>= _COLUMN_BITS
    lines_between = mark & _MOST_LINES
    mark >>= _LINES_BETWEEN_BITS
    return mark >> _COLUMN_BITS, mark & _MOST_COLUMNS, lines_between, value_column
