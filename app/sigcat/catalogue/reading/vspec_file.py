"""One vspec file: its statements (a path with attributes) and its includes, each with its position.

The vspec language is as vss-tools 6.1 reads it: dotted keys, `#include FILE [PREFIX]`
lines, and `includes:` lists on branches.
"""

import re
import sys
from array import array
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat import codes
from sigcat.catalogue.reading.statement import (
    Origin,
    SourceFile,
    Statement,
    mark_of,
    marks_of_items,
    unpacked_mark,
)
from sigcat.catalogue.reading.yaml_document import (
    TEXT,
    Builder,
    Unbuildable,
    duplicate_keys,
    position,
    read_document,
)
from sigcat.catalogue.reading.yaml_scalars import quote_it
from sigcat.findings import Finding, first_at, shown
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.line_numbers import numbered
from sigcat.names import nearest, with_article

_INCLUDE_LINE = re.compile(r"^[ \t]*#include.*$", re.MULTILINE)
_NEARLY_INCLUDE = re.compile(r"^[ \t]*#[ \t]*([A-Za-z]{5,10})[ \t]+\S+\.vspec\b", re.MULTILINE)
"""A comment that names a file as an include does."""
_MISSPELLED_INCLUDES = 100
"""Reported in one file: more than these have one cause."""


_NODE_TYPES = frozenset(("branch", "sensor", "actuator", "attribute", "struct", "property"))


class EntryWords(NamedTuple):
    """The words of findings about the entries of a file."""

    entry: str
    key: str
    field: str
    example: str
    """A key of the file."""


NODES = EntryWords("node", "path", "attribute", "Vehicle.Speed")
UNITS = EntryWords("unit", "key", "field", "km/h")
QUANTITIES = EntryWords("quantity", "key", "field", "velocity")


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


def parse_vspec(
    data: bytes, source: SourceFile, limits: Limits = DEFAULT_LIMITS, words: EntryWords = NODES
) -> VspecFile:
    """Read the bytes of one vspec file, or of one of units or quantities.

    A finding is made of each entry that is not a statement. All others are read.
    """
    document = read_document(data, source.name, limits)
    reading = _Reading(source, Builder(limits, len(document.text)), words, [], list(document.findings))
    findings, includes = reading.findings, reading.includes
    statements: list[Statement] = []
    if isinstance(document.root, MappingNode):
        root = _flattened(document.root) if source.name.endswith(".json") else document.root
        statements = _read_statements(root, reading)
        findings.extend(_misread(*each, source.name) for each in reading.builder.misread)
    elif document.root is not None and not _is_null(document.root):
        findings.append(_not_a_mapping(document.root, source.name, words))
    includes.extend(_include_lines(document.text, source.name, findings))
    findings.extend(islice(_misspelled_includes(document.text, source.name), _MISSPELLED_INCLUDES))
    return VspecFile(source, tuple(statements), tuple(includes), tuple(findings))


class _Reading(NamedTuple):
    """A file while it is read, with the includes and findings so far."""

    source: SourceFile
    builder: Builder
    words: EntryWords
    includes: list[Include]
    findings: list[Finding]

    def unbuildable(self, error: Unbuildable, path: str) -> None:
        """Report what has no value."""
        self.findings.append(
            error.rule.finding(str(error), self.source.name, *position(error.node), path, fix=error.fix)
        )


def _not_a_mapping(root: Node, file: str, words: EntryWords) -> Finding:
    message = f"The file must be a mapping of {words.entry} {words.key}s to {words.field}s, not {_kind(root)}."
    since = ", as since VSS 3.0" if words is NODES else ""
    fix = (
        f"Write `{words.example}:` in place of `- {words.example}:`{since}."
        if _is_list_of_nodes(root)
        else f"Write {words.key}s such as `{words.example}:`, each with its {words.field}s below it."
    )
    return codes.NOT_A_MAPPING.finding(message, file, *position(root), fix=fix)


def _flattened(root: MappingNode) -> MappingNode:
    """The nodes of an exported tree, which nest under `children`, each under its path."""
    found: list[tuple[Node, Node]] = []
    waiting: list[tuple[str, Node, Node]] = [("", key, node) for key, node in reversed(root.value)]
    while waiting:
        prefix, key, node = waiting.pop()
        path = f"{prefix}{key.value}" if isinstance(key, ScalarNode) else ""
        below = [each for name, each in node.value if name.value == "children"] if isinstance(node, MappingNode) else []
        nested = [pair for each in below if isinstance(each, MappingNode) for pair in each.value]
        if nested:
            own = [(name, value) for name, value in node.value if name.value != "children"]
            node = MappingNode(node.tag, own, node.start_mark, node.end_mark)
        named = ScalarNode(key.tag, path, key.start_mark, key.end_mark) if path else key
        found.append((named, node))
        waiting += [(f"{path}.", *pair) for pair in reversed(nested)]
    return MappingNode(root.tag, found, root.start_mark, root.end_mark)


def _read_statements(root: MappingNode, reading: _Reading) -> list[Statement]:
    _report_duplicates(root, reading.words.entry, "", reading)
    statements: dict[str, Statement] = {}
    try:
        pairs = reading.builder.pairs(root)
    except Unbuildable as error:
        reading.unbuildable(error, "")
        return []
    for key, node in pairs:
        statement = _read_statement(key, node, reading)
        if statement is not None:
            statements[statement.path] = statement
    return list(statements.values())


def _read_statement(key: Node, node: Node, reading: _Reading) -> Statement | None:
    source, words = reading.source, reading.words
    try:
        path = reading.builder.key(key)
        if not isinstance(path, str) or not path:
            raise Unbuildable(
                f"The {words.key} of a {words.entry} must be text, not {shown(path)}.", key, fix=quote_it(path)
            )
        if not isinstance(node, MappingNode):
            raise Unbuildable(
                f"{path!r} must be a mapping of {words.field}s, not {_kind(node)}.", node, codes.NOT_A_MAPPING
            )
        values, marks, collections = _attributes(node, reading)
    except Unbuildable as error:
        reading.unbuildable(error, key.value if isinstance(key, ScalarNode) else "")
        return None
    if len(values) != len(node.value):
        _report_duplicates(node, words.field, path, reading)
    includes_at = None
    if "includes" in values and values.get("type") == "branch":
        mark = marks.pop(list(values).index("includes"))
        includes_at = (values.pop("includes"), mark)
    mark = mark_of(key.start_mark, key.start_mark)
    if nested := {name: inner for name in collections if (inner := nested_node(name, values.get(name)))}:
        reading.findings.append(_nodes_nested(nested, path, node, source.name))
    for name in filter(collections.__contains__, values):
        marks.extend(marks_of_items(collections[name], values[name]))
    statement = Statement(path, source, values, mark, array("Q", marks))
    if includes_at is not None and includes_at[0] is not None:
        reading.includes.extend(_include_list(statement, *includes_at, reading.findings))
    return statement


def nested_node(name: str, value: Any) -> str:
    """The name of a node that is written inside another one, right below it or under `children`, as an export has it."""
    if _is_node(value):
        return name
    below = value if name == "children" and isinstance(value, dict) else {}
    return str(next(iter(below))) if below and all(map(_is_node, below.values())) else ""


def _is_node(value: Any) -> bool:
    return isinstance(value, dict) and isinstance(value.get("type"), str) and value["type"] in _NODE_TYPES


def _nodes_nested(nested: Mapping[str, str], path: str, node: MappingNode, file: str) -> Finding:
    """One finding for each node in which others are written."""
    attribute, name = next(iter(nested.items()))
    message = f"{name!r} is written inside {path!r}, and nodes do not nest: it is taken for an attribute."
    key = next(key for key, _ in node.value if key.value == attribute)
    fix = f"Write `{path}.{name}:` at the beginning of a line, and so for each node below."
    return codes.NODES_NESTED.finding(message, file, *position(key), path, fix=fix)


def _is_list_of_nodes(root: Node) -> bool:
    """Whether a document has the form of VSS 2: a list of mappings, each with a path as its first key.

    The attributes are below that key, or beside it where they are indented as little.
    """
    items = root.value if isinstance(root, SequenceNode) else []
    return bool(items) and all(
        isinstance(item, MappingNode)
        and item.value
        and (isinstance(item.value[0][1], MappingNode) or not item.value[0][1].value)
        for item in items
    )


def _attributes(node: MappingNode, reading: _Reading) -> tuple[dict[str, Any], list[int], dict[str, Node]]:
    """Values by name, the packed position of each in the same order, and the nodes of those that hold others."""
    builder, words = reading.builder, reading.words
    values: dict[str, Any] = {}
    marks: list[int] = []
    collections: dict[str, Node] = {}
    for key, value in builder.pairs(node):
        name = sys.intern(key.value) if key.tag == TEXT else builder.key(key)
        if not isinstance(name, str):
            raise Unbuildable(
                f"The name of {with_article(words.field)} must be text, not {shown(name)}.", key, fix=quote_it(name)
            )
        start, end = key.start_mark, value.start_mark
        if name in values:
            marks[list(values).index(name)] = mark_of(start, end)
        else:
            marks.append(mark_of(start, end))
        if isinstance(value, ScalarNode):
            values[name] = builder.scalar(value)
        else:
            values[name] = builder.value(value)
            collections[name] = value
    return values, marks, collections


def _report_duplicates(node: MappingNode, what: str, path: str, reading: _Reading) -> None:
    for key, first in duplicate_keys(node):
        if key.value == "<<":
            continue
        at = first_at(reading.source.name, position(first)[0])
        message = f"{what.capitalize()} {key.value!r} is given twice, {at}; only the last one counts."
        place = (reading.source.name, *position(key), path or key.value)
        reading.findings.append(codes.DUPLICATE_KEY.finding(message, *place, fix="Remove one of the two."))


def _misread(node: ScalarNode, value: int, file: str) -> Finding:
    base = "octal" if ":" not in node.value else "base 60"
    message = f"{node.value} is {value} in YAML, as {base}."
    fix = f"Write {value}, or quote the text."
    return codes.NUMBER_IN_ANOTHER_BASE.finding(message, file, *position(node), fix=fix)


def _include_list(statement: Statement, listed: Any, mark: int, findings: list[Finding]) -> Iterator[Include]:
    line, _, lines_between, column = unpacked_mark(mark)
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
    for line, match in numbered(text, _INCLUDE_LINE.finditer(text)):
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


def _misspelled_includes(text: str, file: str) -> Iterator[Finding]:
    """Comments that were probably meant as includes: `#inlcude A.vspec`, `# include A.vspec`."""
    if ".vspec" not in text:
        return
    for line, match in numbered(text, _NEARLY_INCLUDE.finditer(text)):
        if match.group().lstrip().startswith("#include") or not nearest(match[1], ["include"]):
            continue
        column = match.group().index("#") + 1
        message = f"{match.group().strip()!r} is a comment, not an include."
        fix = "Write `#include`, in lower case and without a space, or reword the comment."
        yield codes.INCLUDE_MISSPELLED.finding(message, file, line, column, fix=fix)


def _kind(node: Node) -> str:
    return "a list" if isinstance(node, SequenceNode) else "a single value"


def _is_null(node: Node) -> bool:
    return isinstance(node, ScalarNode) and node.tag.endswith(":null")
