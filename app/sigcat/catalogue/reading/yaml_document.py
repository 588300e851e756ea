"""Read YAML with positions, safely: bytes in, a composed document or findings out.

libyaml composes nodes with marks many times faster than Python does, but its composer recurses: deep nesting
would end the process. Depth is therefore bounded before composing, by a count that costs next to nothing for
files that cannot nest deeply. Values are built here, with the meaning of `yaml.safe_load` (YAML 1.1).
"""

import gc
import re
import sys
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from itertools import accumulate
from typing import Any, NamedTuple

import yaml
from yaml.constructor import ConstructorError, SafeConstructor
from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat import codes
from sigcat.catalogue.reading.whole_numbers import held_as_double
from sigcat.findings import Finding, RuleCode
from sigcat.limits import DEFAULT_LIMITS, NUMBER_CHARACTERS, Limits
from sigcat.text_lines import line_and_column, lines_of

_LIBYAML: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

_STANDARD = "tag:yaml.org,2002:"
TEXT = _STANDARD + "str"
"""Tag of a scalar that is a text."""
_SEQUENCE = _STANDARD + "seq"
_MAPPING = _STANDARD + "map"
_OPENERS = ("[", "{", "- ", "-\t", "? ", "?\t")
"""Tokens that can open a collection without more indentation than the line before."""
_SHALLOW_OPENERS = 2_000
"""So many openers cannot exhaust the stack, however they nest; a file with fewer needs no exact count."""
_INDENTATION = " " * 200
_ITEM = r"""(?:'[^'\n]*+'|"[^"\\\n]*+"|[^\s'"\[\]{}#,][^'"\[\]{}#,\n]*+)"""
_LIST_ON_A_LINE = rf"""[^\n\[\]{{}}'"#]*+\[[ \t]*+(?:{_ITEM}[ \t]*+(?:,[ \t]*+{_ITEM}[ \t]*+)*+)?+\][ \t]*+"""
"""A line with one list, opened and closed: `allowed: [LOW, 'HIGH']`. Quoted parts close on the line and no other bracket
is in it, so whatever came before, the line leaves the depth as it was. Linear: nothing is tried twice."""
_BOOLEANS = {"yes": True, "true": True, "on": True, "no": False, "false": False, "off": False}


class _Loader(_LIBYAML):  # type: ignore[misc]
    """libyaml's loader; asks for the tag of a plain scalar once for each spelling (a third of the time of a file).

    It counts nodes while they are made: what has too many is given up before it takes time and memory.
    """

    def __init__(self, text: str, values: int) -> None:
        super().__init__(text)
        self._values = self._left = values

    def descend_resolver(self, current_node: Any, current_index: Any) -> None:
        """No tag depends on the path of a node."""

    def ascend_resolver(self) -> None:
        """No tag depends on the path of a node."""

    def resolve(self, kind: Any, value: Any, implicit: Any) -> Any:
        """Tag of a node without one."""
        self._left -= 1
        if self._left < 0:
            raise _too_many(self._values)
        if kind is not ScalarNode:
            return _SEQUENCE if kind is SequenceNode else _MAPPING
        if not implicit[0]:
            return TEXT
        if len(value) < _SHORT:
            return _plain_tag(value)
        return TEXT if value[0].isalpha() else _tag_of_plain(value)


def _tag_of_plain(value: str) -> str:
    tag: str = _RESOLVER.resolve(ScalarNode, value, (True, False))  # type: ignore[no-untyped-call]
    return tag


_RESOLVER = yaml.resolver.Resolver()
_DIRECTIVES = 100
_OTHER_BREAKS = "\x85\u2028\u2029"
_BREAKS = f"\n\r{_OTHER_BREAKS}"
"""Whatever ends a line in YAML 1.1."""
_SHORT = 32
"""Plain texts of this length or more that begin with a letter are texts: no other value of YAML is so long and does."""
_plain_tag = lru_cache(maxsize=8192)(_tag_of_plain)


class Document(NamedTuple):
    """A composed YAML document: the text, its root node (None if empty) and what was wrong with it."""

    text: str
    root: Node | None
    findings: tuple[Finding, ...]


class Unbuildable(Exception):
    """A YAML node has no value: an unknown tag, a cycle, a malformed number. `rule` is the one that it breaks."""

    def __init__(self, message: str, node: Node, rule: RuleCode = codes.NOT_A_VALUE, fix: str = "") -> None:
        super().__init__(message)
        self.fix = fix
        self.node = node
        self.rule = rule


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
    """Compose `data`. Every error is a finding that names `name`; a document with an error has no root."""
    if len(data) > limits.file_bytes:
        return _refused(
            "", name, codes.FILE_TOO_LARGE, f"The file has {len(data):,} bytes; the limit is {limits.file_bytes:,}."
        )
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        return _undecodable(data, name, error.start)
    try:
        _refuse_directives(text)
        _refuse_deep_nesting(text, limits)
        with collector_paused():
            root = _Loader(text, limits.values).get_single_node()
            if root is not None and _has_other_breaks(text):
                _count_lines_as_editors(root, text)
    except _BeyondLimit as error:
        return _refused(text, name, error.rule, str(error), error.line, error.column)
    except yaml.MarkedYAMLError as error:
        return _syntax_error(text, name, error)
    except yaml.reader.ReaderError as error:
        line = text.count("\n", 0, error.position) + 1
        message = f"Character U+{_code_point(error):04X} is not allowed in YAML."
        return _refused(text, name, codes.NOT_YAML, message, line, 1, "Remove the character.")
    return Document(text, root, ())


def _has_other_breaks(text: str) -> bool:
    return not text.isascii() and any(ending in text for ending in _OTHER_BREAKS)


def _count_lines_as_editors(root: Node, text: str) -> None:
    """Replace the marks of all nodes: libyaml counts more ends of lines."""
    starts, done, waiting = _starts_of_lines(text), set[int](), [root]
    while waiting:
        node = waiting.pop()
        if id(node) in done:
            continue
        done.add(id(node))
        node.start_mark, node.end_mark = _mark_at(node.start_mark, starts), _mark_at(node.end_mark, starts)
        if isinstance(node, MappingNode):
            waiting += (each for pair in node.value for each in pair)
        elif isinstance(node, SequenceNode):
            waiting += node.value


def _starts_of_lines(text: str) -> Sequence[int]:
    return [0, *accumulate(map(len, lines_of(text, keepends=True)))]


def _mark_at(mark: Any, starts: Sequence[int]) -> yaml.Mark:
    line = bisect_right(starts, mark.index) - 1
    return yaml.Mark(mark.name, mark.index, line, mark.index - starts[line], None, 0)


def _undecodable(data: bytes, name: str, at: int) -> Document:
    if _is_binary(data):
        return _refused("", name, codes.NOT_UTF_8, "The file is not a text.", fix="Name another file, or exclude it.")
    line, column = data.count(b"\n", 0, at) + 1, at - data.rfind(b"\n", 0, at)
    message = f"Byte 0x{data[at]:02X} is not UTF-8."
    return _refused("", name, codes.NOT_UTF_8, message, line, column, "Save the file as UTF-8.")


def _is_binary(data: bytes) -> bool:
    """Whether bytes are binary, not text in an encoding that an editor writes: each of their lines has control characters."""
    start = data[:8_000]
    return not start.startswith(_MARKS_OF_UTF_16) and len(start.translate(None, _CONTROLS)) < len(start)


_MARKS_OF_UTF_16 = (b"\xff\xfe", b"\xfe\xff")
_CONTROLS = bytes({*range(32)} - {*b"\t\n\r\f\x1b"})


def position(node: Node) -> tuple[int, int]:
    """Line and column of a node, from 1."""
    line, column = node.start_mark.line, node.start_mark.column
    return line + 1, column + 1


def duplicate_keys(node: MappingNode) -> Iterator[tuple[ScalarNode, ScalarNode]]:
    """The keys that a mapping has already had before, each with the first one."""
    seen: dict[str, ScalarNode] = {}
    for key, _ in node.value:
        if isinstance(key, ScalarNode) and seen.setdefault(key.value, key) is not key:
            yield key, seen[key.value]


class Builder:
    """Builds plain values from the nodes of one document; counts them, so that aliases cannot multiply unseen.

    A text of `characters` cannot write more values than that; with aliases it may give four times as many.
    """

    def __init__(self, limits: Limits = DEFAULT_LIMITS, characters: int | None = None) -> None:
        self._left = limits.values if characters is None else min(limits.values, 10_000 + 4 * characters)
        self._nesting = limits.nesting
        self._above: set[int] = set()
        self.misread: list[tuple[ScalarNode, int]] = []
        """Numbers that YAML 1.1 reads in another base than people do, with their values: `0100` and `1:30`."""

    def value(self, node: Node) -> Any:
        """The value of `node` as `yaml.safe_load` would give it. Raises Unbuildable."""
        if isinstance(node, ScalarNode):
            return self.scalar(node)
        if id(node) in self._above:
            raise Unbuildable("An alias refers to a collection that contains it.", node, codes.ALIAS_TO_ITSELF)
        if len(self._above) > self._nesting:
            raise Unbuildable(f"Collections nest deeper than {self._nesting} levels.", node)
        if node.tag not in (_SEQUENCE, _MAPPING):
            raise Unbuildable(f"Collections tagged {_short(node.tag)} are not supported.", node)
        self._above.add(id(node))
        try:
            if isinstance(node, SequenceNode):
                return [self.value(item) for item in node.value]
            assert isinstance(node, MappingNode)
            return {self.key(key): self.value(item) for key, item in self.pairs(node)}
        finally:
            self._above.discard(id(node))

    def pairs(self, node: MappingNode) -> "Pairs":
        """The pairs of a mapping with its merge keys resolved. Raises Unbuildable."""
        return merged_pairs(node, self._left)

    def scalar(self, node: ScalarNode) -> Any:
        """The value of a scalar. Raises Unbuildable."""
        self._left -= 1
        if self._left < 0:
            raise Unbuildable("The document has too many values, or its aliases multiply.", node, codes.ALIAS_TO_ITSELF)
        tag: str = node.tag
        if tag == TEXT:
            text: str = node.value
            return sys.intern(text) if len(text) < _SHORT else text
        build = _SCALARS.get(tag, _any_scalar)
        try:
            value = build(node)
        except (ConstructorError, ValueError, KeyError, OverflowError) as error:
            problem = getattr(error, "problem", None) or str(error)
            raise Unbuildable(f"{node.value[:40]!r} is not a valid value: {problem}.", node) from None
        if tag == _INTEGER and re.match(_OTHER_BASE, node.value):
            self.misread.append((node, value))
        return value

    def key(self, node: Node) -> Any:
        """The value of a mapping key, which has to be a scalar. Raises Unbuildable."""
        if not isinstance(node, ScalarNode):
            raise Unbuildable("A key must be a single value, not a list or mapping.", node)
        return self.scalar(node)


Pairs = list[tuple[Node, Node]]


def merged_pairs(node: MappingNode, most: int = DEFAULT_LIMITS.values) -> Pairs:
    """The pairs of a mapping with its merge keys (`<<`) resolved: own keys win over merged ones.

    Raises Unbuildable, also where more than `most` pairs are merged.
    """
    return _Merging(most).pairs(node) if _has_merge_key(node) else node.value


def _has_merge_key(node: MappingNode) -> bool:
    return any(key.tag == _MERGE for key, _ in node.value)


class _Merging:
    """The merge keys of one mapping, followed as far as the merged mappings have some themselves."""

    def __init__(self, most: int) -> None:
        self._left = most
        self._above: list[Node] = []

    def pairs(self, node: MappingNode) -> Pairs:
        """Pairs of the merged mappings, each before those that win over them, then the own ones."""
        self._above.append(node)
        merged: Pairs = []
        for key, value in node.value:
            if key.tag == _MERGE:
                merged += self._sources(value)
        self._above.pop()
        return [*merged, *(pair for pair in node.value if pair[0].tag != _MERGE)]

    def _sources(self, value: Node) -> Pairs:
        pairs: Pairs = []
        for source in reversed(value.value if isinstance(value, SequenceNode) else [value]):
            pairs += self._source(source, value)
        return pairs

    def _source(self, source: Node, value: Node) -> Pairs:
        if not isinstance(source, MappingNode):
            raise Unbuildable("`<<` must be a mapping or a list of mappings.", value)
        if source in self._above:
            raise Unbuildable("`<<` merges a mapping into itself.", value)
        self._left -= 1 + len(source.value)
        if self._left < 0 or len(self._above) > _MERGES_DEEP:
            raise Unbuildable("The merge keys (`<<`) multiply.", value, codes.ALIAS_TO_ITSELF)
        return self.pairs(source) if _has_merge_key(source) else source.value


_MERGES_DEEP = 64
"""Mappings that a mapping may merge one through another."""
_MERGE = _STANDARD + "merge"
_CONSTRUCTOR = SafeConstructor()


def _integer(node: ScalarNode) -> int:
    text = _readable(node)
    if text.isdecimal() and text.isascii() and (text[0] != "0" or text == "0"):
        return int(text) if len(text) < _SURELY_HELD else held_as_double(int(text))
    return held_as_double(int(_CONSTRUCTOR.construct_yaml_int(node)))


def _number(node: ScalarNode) -> float:
    _readable(node)
    return float(_CONSTRUCTOR.construct_yaml_float(node))


def _readable(node: ScalarNode) -> str:
    """The text of a number. Raises ValueError for one so long that reading it takes the square of its length."""
    text: str = node.value
    if len(text) > NUMBER_CHARACTERS:
        raise ValueError(f"a number has at most {NUMBER_CHARACTERS:,} characters")
    return text


_SURELY_HELD = 300
"""Digits of a number that a double holds."""
_INTEGER = _STANDARD + "int"
_OTHER_BASE = r"[-+]?(?:0[0-7_]|[^:]*:)"
_SCALARS: dict[str, Callable[[ScalarNode], Any]] = {
    _INTEGER: _integer,
    _STANDARD + "float": _number,
    _STANDARD + "bool": lambda node: _BOOLEANS[node.value.lower()],
    _STANDARD + "null": lambda _: None,
    _STANDARD + "value": lambda node: node.value,
}


def _any_scalar(node: ScalarNode) -> Any:
    return SafeConstructor().construct_object(node)


class _BeyondLimit(Exception):
    """The document is larger than it may be."""

    def __init__(self, rule: RuleCode, message: str, line: int = 0, column: int = 0) -> None:
        super().__init__(message)
        self.rule = rule
        self.line = line
        self.column = column


def _too_many(values: int) -> _BeyondLimit:
    return _BeyondLimit(codes.NOT_A_VALUE, f"The file has more than {values:,} values, which is the limit.")


def _refuse_directives(text: str) -> None:
    """A parser compares each directive with all before it, and no tree needs one."""
    if sum(text.count(f"{ending}%") for ending in _BREAKS) > _DIRECTIVES:
        raise _BeyondLimit(codes.NOT_YAML, f"The file has more than {_DIRECTIVES} lines that begin with `%`.", 1, 1)


def _refuse_deep_nesting(text: str, limits: Limits) -> None:
    openers = sum(map(text.count, _OPENERS))
    if openers > _SHALLOW_OPENERS:
        is_list_on_a_line = re.compile(_LIST_ON_A_LINE).fullmatch
        openers -= sum(1 for line in text.split("\n") if "[" in line and is_list_on_a_line(line))
    if openers <= _SHALLOW_OPENERS and _INDENTATION not in text:
        return
    depth = count = 0
    for event in yaml.parse(text, Loader=_LIBYAML):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            count += 1
            if count > limits.values:
                raise _too_many(limits.values)
            if depth > limits.nesting:
                mark: Any = event.start_mark
                message = f"Collections nest deeper than {limits.nesting} levels."
                line, column = line_and_column(text, mark.index)
                raise _BeyondLimit(codes.NESTING_TOO_DEEP, message, line + 1, column + 1)
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1


def _refused(
    text: str, name: str, rule: RuleCode, message: str, line: int = 0, column: int = 0, fix: str = ""
) -> Document:
    return Document(text, None, (rule.finding(message, name, line, column, fix=fix),))


def _syntax_error(text: str, name: str, error: yaml.MarkedYAMLError) -> Document:
    from sigcat.catalogue.reading.yaml_syntax import syntax_fault  # seldom needed

    fault = syntax_fault(text, error)
    return _refused(text, name, codes.NOT_YAML, fault.message, fault.line, fault.column, fault.fix)


def _code_point(error: Any) -> int:
    return error.character if isinstance(error.character, int) else ord(error.character)


def _short(tag: str) -> str:
    return tag.replace(_STANDARD, "!!")
