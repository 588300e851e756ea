"""One vspec file: its statements (a path with attributes) and its includes, each with its position.

The vspec language is as vss-tools 6.1 reads it: dotted keys, `#include FILE [PREFIX]`
lines, and `includes:` lists on branches.
"""

import re
import sys
from array import array
from collections.abc import Iterator, Mapping
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
from sigcat.findings import Finding, shown
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import nearest

_INCLUDE_LINE = re.compile(r"^[ \t]*#include.*$", re.MULTILINE)
_NEARLY_INCLUDE = re.compile(r"^[ \t]*#[ \t]*([A-Za-z]{5,10})[ \t]+\S+\.vspec\b", re.MULTILINE)
"""A comment that names a file as an include does."""


_NODE_TYPES = frozenset(("branch", "sensor", "actuator", "attribute", "struct", "property"))


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
        builder = Builder(limits, len(document.text))
        root = _flattened(document.root) if source.name.endswith(".json") else document.root
        _read_statements(root, source, builder, statements, includes, findings)
        findings.extend(_misread(*each, source.name) for each in builder.misread)
    elif document.root is not None and not _is_null(document.root):
        line, column = position(document.root)
        message = f"The file must be a mapping of node paths to attributes, not {_kind(document.root)}."
        fix = (
            "Write `Vehicle.Speed:` in place of `- Vehicle.Speed:`, as since VSS 3.0."
            if _is_list_of_nodes(document.root)
            else "Write paths such as `Vehicle.Speed:`, each with its attributes below it."
        )
        findings.append(codes.NOT_A_MAPPING.finding(message, source.name, line, column, fix=fix))
    includes.extend(_include_lines(document.text, source.name, findings))
    findings.extend(_misspelled_includes(document.text, source.name))
    return VspecFile(source, tuple(statements), tuple(includes), tuple(findings))


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
        pairs = builder.pairs(root)
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
            raise Unbuildable(f"The path of a node must be text, not {shown(path)}.", key)
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
    mark = mark_of(key.start_mark, key.start_mark)
    if nested := {name: inner for name in collections if (inner := nested_node(name, values.get(name)))}:
        findings.append(_nodes_nested(nested, path, node, source.name))
    for name in filter(collections.__contains__, values):
        marks.extend(marks_of_items(collections[name], values[name]))
    statement = Statement(path, source, values, mark, array("Q", marks))
    if includes_at is not None and includes_at[0] is not None:
        includes.extend(_include_list(statement, *includes_at, findings))
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


def _attributes(node: MappingNode, builder: Builder) -> tuple[dict[str, Any], list[int], dict[str, Node]]:
    """Values by name, the packed position of each in the same order, and the nodes of those that hold others."""
    values: dict[str, Any] = {}
    marks: list[int] = []
    collections: dict[str, Node] = {}
    for key, value in builder.pairs(node):
        name = sys.intern(key.value) if key.tag == TEXT else builder.key(key)
        if not isinstance(name, str):
            raise Unbuildable(f"The name of an attribute must be text, not {shown(name)}.", key)
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


def _misspelled_includes(text: str, file: str) -> Iterator[Finding]:
    """Comments that were probably meant as includes: `#inlcude A.vspec`, `# include A.vspec`."""
    if ".vspec" not in text:
        return
    for match in _NEARLY_INCLUDE.finditer(text):
        if match.group().lstrip().startswith("#include") or not nearest(match[1], ["include"]):
            continue
        line, column = text.count("\n", 0, match.start()) + 1, match.group().index("#") + 1
        message = f"{match.group().strip()!r} is a comment, not an include."
        fix = "Write `#include`, in lower case and without a space, or reword the comment."
        yield codes.INCLUDE_MISSPELLED.finding(message, file, line, column, fix=fix)


def _kind(node: Node) -> str:
    return "a list" if isinstance(node, SequenceNode) else "a single value"


def _is_null(node: Node) -> bool:
    return isinstance(node, ScalarNode) and node.tag.endswith(":null")
