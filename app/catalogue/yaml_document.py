"""Read YAML with positions, safely: bytes in, a composed document or findings out.

libyaml composes nodes with marks many times faster than Python does, but its composer recurses: deep nesting
would end the process. Depth is therefore bounded before composing, by a count that costs next to nothing for
files that cannot nest deeply. Values are built here, with the meaning of `yaml.safe_load` (YAML 1.1).
"""

import gc
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import yaml
from yaml.constructor import ConstructorError, SafeConstructor
from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.findings import Finding

LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

_STANDARD = "tag:yaml.org,2002:"
_OPENERS = ("[", "{", "- ", "-\t", "? ", "?\t")
"""What can open a collection without more indentation than the line before."""
_SHALLOW_OPENERS = 2_000
"""So many openers cannot exhaust the stack, however they nest; a file with fewer needs no exact count."""
_INDENTATION = " " * 200
_BOOLEANS = {"yes": True, "true": True, "on": True, "no": False, "false": False, "off": False}


class Document(NamedTuple):
    """A composed YAML document: the text, its root node (None if empty) and what was wrong with it."""

    text: str
    root: Node | None
    findings: tuple[Finding, ...]


class Unbuildable(Exception):
    """A YAML node has no value: an unknown tag, a cycle, a number that is none."""

    def __init__(self, message: str, node: Node) -> None:
        super().__init__(message)
        self.node = node


@contextmanager
def collector_paused() -> Iterator[None]:
    """Pause the cyclic garbage collector: it would walk half-built trees again and again (three times slower)."""
    was_enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_enabled:
            gc.enable()


def read_document(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Document:
    """Compose `data`. Every defect is a finding that names `name`; a document with a defect has no root."""
    if len(data) > limits.file_bytes:
        return _refused("", name, "R003", f"The file has {len(data):,} bytes; the limit is {limits.file_bytes:,}.")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        column = error.start - data.rfind(b"\n", 0, error.start)
        message = f"Byte 0x{data[error.start]:02X} is not UTF-8."
        return _refused("", name, "R002", message, line, column, "Save the file as UTF-8.")
    try:
        _refuse_deep_nesting(text, limits.nesting)
        with collector_paused():
            root = yaml.compose(text, Loader=LOADER)
    except _TooDeep as error:
        message = f"Collections nest deeper than {limits.nesting} levels."
        return _refused(text, name, "R004", message, error.line, error.column)
    except yaml.MarkedYAMLError as error:
        return _syntax_error(text, name, error)
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        message = f"Character U+{_code_point(error):04X} is not allowed in YAML."
        return _refused(text, name, "R001", message, line, 1)
    return Document(text, root, ())


def position(node: Node) -> tuple[int, int]:
    """Line and column of a node, from 1."""
    return node.start_mark.line + 1, node.start_mark.column + 1


def duplicate_keys(node: MappingNode) -> Iterator[ScalarNode]:
    """The keys of a mapping that stand in it before."""
    seen = set()
    for key, _ in node.value:
        if isinstance(key, ScalarNode):
            if key.value in seen:
                yield key
            seen.add(key.value)


class Builder:
    """Builds plain values from the nodes of one document; counts them, so that aliases cannot multiply unseen."""

    def __init__(self, limits: Limits = DEFAULT_LIMITS) -> None:
        self._left = limits.values
        self._nesting = limits.nesting
        self._above: set[int] = set()

    def value(self, node: Node) -> Any:
        """The value of `node` as `yaml.safe_load` would give it. Raises Unbuildable."""
        if isinstance(node, ScalarNode):
            return self.scalar(node)
        if id(node) in self._above:
            raise Unbuildable("An alias refers to the collection that it stands in.", node)
        if len(self._above) > self._nesting:
            raise Unbuildable(f"Collections nest deeper than {self._nesting} levels.", node)
        if node.tag not in (_STANDARD + "seq", _STANDARD + "map"):
            raise Unbuildable(f"Collections tagged {_short(node.tag)} are not supported.", node)
        self._above.add(id(node))
        try:
            if isinstance(node, SequenceNode):
                return [self.value(item) for item in node.value]
            return {self.key(key): self.value(item) for key, item in merged_pairs(node)}
        finally:
            self._above.discard(id(node))

    def scalar(self, node: ScalarNode) -> Any:
        """The value of a scalar. Raises Unbuildable."""
        self._left -= 1
        if self._left < 0:
            raise Unbuildable("The document has too many values, or its aliases multiply.", node)
        tag: str = node.tag
        if tag == _STR:
            text: str = node.value
            return sys.intern(text) if len(text) < 24 else text
        build = _SCALARS.get(tag, _any_scalar)
        try:
            return build(node)
        except (ConstructorError, ValueError, KeyError, OverflowError) as error:
            problem = getattr(error, "problem", None) or str(error)
            raise Unbuildable(f"{node.value[:40]!r} is no value: {problem}.", node) from None

    def key(self, node: Node) -> Any:
        """The value of a mapping key, which has to be a scalar. Raises Unbuildable."""
        if not isinstance(node, ScalarNode):
            raise Unbuildable("A collection cannot be a key.", node)
        return self.scalar(node)


def merged_pairs(node: MappingNode) -> list[tuple[Node, Node]]:
    """The pairs of a mapping with its merge keys (`<<`) resolved: own keys win over merged ones."""
    if not any(key.tag == _MERGE for key, _ in node.value):
        pairs: list[tuple[Node, Node]] = node.value
        return pairs
    merged: list[tuple[Node, Node]] = []
    own: list[tuple[Node, Node]] = []
    for key, value in node.value:
        if key.tag != _MERGE:
            own.append((key, value))
            continue
        sources = value.value if isinstance(value, SequenceNode) else [value]
        for source in reversed(sources):
            if not isinstance(source, MappingNode) or source is node:
                raise Unbuildable("A merge key takes a mapping or a list of mappings.", value)
            merged.extend(source.value)
    return merged + own


_STR = _STANDARD + "str"
_MERGE = _STANDARD + "merge"
_CONSTRUCTOR = SafeConstructor()


def _integer(node: ScalarNode) -> int:
    text: str = node.value
    if text.isdecimal() and text.isascii() and (text[0] != "0" or text == "0"):
        return int(text)
    return int(_CONSTRUCTOR.construct_yaml_int(node))


_SCALARS: dict[str, Callable[[ScalarNode], Any]] = {
    _STANDARD + "int": _integer,
    _STANDARD + "float": _CONSTRUCTOR.construct_yaml_float,
    _STANDARD + "bool": lambda node: _BOOLEANS[node.value.lower()],
    _STANDARD + "null": lambda node: None,
    _STANDARD + "value": lambda node: node.value,
}


def _any_scalar(node: ScalarNode) -> Any:
    return SafeConstructor().construct_object(node)


class _TooDeep(Exception):
    def __init__(self, line: int, column: int) -> None:
        self.line = line
        self.column = column


def _refuse_deep_nesting(text: str, limit: int) -> None:
    if sum(map(text.count, _OPENERS)) <= _SHALLOW_OPENERS and _INDENTATION not in text:
        return
    depth = 0
    for event in yaml.parse(text, Loader=LOADER):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > limit:
                raise _TooDeep(event.start_mark.line + 1, event.start_mark.column + 1)
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1


def _refused(
    text: str, name: str, rule: str, message: str, line: int = 0, column: int = 0, fix: str = ""
) -> Document:
    return Document(text, None, (Finding(rule, "error", message, name, line, column, fix=fix),))


def _syntax_error(text: str, name: str, error: yaml.MarkedYAMLError) -> Document:
    mark = error.problem_mark or error.context_mark
    line, column = (mark.line + 1, mark.column + 1) if mark else (0, 0)
    message = ", ".join(part for part in (error.context, error.problem) if part)
    return _refused(text, name, "R001", f"Not valid YAML: {message}.", line, column)


def _code_point(error: Any) -> int:
    return error.character if isinstance(error.character, int) else ord(error.character)


def _short(tag: str) -> str:
    return tag.replace(_STANDARD, "!!")
