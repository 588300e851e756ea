"""Function documents, YAML and JSON: bytes in; the value, the findings and the place of every value out."""

import hashlib
import json
import math
import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import cached_property
from typing import Any, NamedTuple, Protocol

from yaml.nodes import CollectionNode, MappingNode, Node, ScalarNode, SequenceNode

from sigcat.catalogue.reading.yaml_document import (
    Builder,
    Unbuildable,
    duplicate_keys,
    merged_pairs,
    position,
    read_document,
)
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits

Pointer = tuple[str | int, ...]
"""Keys and positions from the root of a document to a value in it."""
Place = tuple[int, int]
"""Line and column, from 1; (0, 0) if unknown."""

_TOKEN = re.compile(r'("(?:[^"\\]|\\.)*+(?:"|\\?\Z))(\s*:)?|[\[\]{}]|[^\s\[\]{},:"]++', re.DOTALL)
"""Keys with their colon, and values, of JSON; an unterminated text runs to the end, so that the search stays linear."""
MOST_COLLECTIONS = 200_000
"""Lists and mappings in one document: twenty times those of a function with 10,000 signals."""
_NO_NUMBERS = ("NaN", "Infinity", "-Infinity")


class Places(Protocol):
    """Where the value at a pointer stands, or the nearest one around it that exists; or its key, if it has one."""

    def __call__(self, pointer: Pointer, *, of_key: bool = False) -> Place: ...


class Document(NamedTuple):
    """A document that was read. `value` is None if it could not be."""

    name: str
    digest: str
    """SHA-256 of the bytes."""
    value: Any
    findings: tuple[Finding, ...]
    place: "Places"


def pointer_text(pointer: Pointer) -> str:
    """RFC 6901: `("a", 0, "b/c")` → `/a/0/b~1c`."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in pointer)


def read_yaml(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Document:
    """Read YAML. A key given twice is a finding, and so is a value that YAML cannot build."""
    crowded = _crowded(data, name, limits, (b"{", b"[", b"- "))
    if crowded is not None:
        return Document(name, _digest(data), None, (crowded,), _YamlPlaces(None))
    document = read_document(data, name, limits)
    findings = list(document.findings)
    value = None
    if document.root is not None:
        try:
            value = Builder(limits, len(document.text)).value(document.root)
            findings.extend(_yaml_duplicates(document.root, name))
        except Unbuildable as error:
            findings.append(Finding("R014", "error", str(error), name, *position(error.node)))
    if value is None and not findings:
        findings.append(Finding("F002", "error", "The file is empty.", name, 1, 1))

    return Document(name, _digest(data), value, tuple(findings), _YamlPlaces(document.root))


def read_json(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Document:
    """Read JSON as RFC 8259 has it: no NaN, no key twice, UTF-8."""
    crowded = _crowded(data, name, limits, (b"{", b"["))
    text, finding = ("", crowded) if crowded is not None else _decoded(data, name, limits)
    value = None
    findings = [finding] if finding else []
    if not findings:
        value, findings = _parsed(text, name, limits.nesting)
    return Document(name, _digest(data), value, tuple(findings), _JsonPlaces(text if value is not None else ""))


def _crowded(data: bytes, name: str, limits: Limits, openers: tuple[bytes, ...]) -> Finding | None:
    """A finding if a document may hold more lists and mappings than any function has; larger files have limits of their own.

    Each of them can be wrong in several ways, and a report of millions of lines helps nobody.
    """
    if len(data) > limits.file_bytes:
        return None
    count, values = sum(map(data.count, openers)), data.count(b",")
    if count > MOST_COLLECTIONS:
        message = f"The document has {count:,} lists and mappings; the limit is {MOST_COLLECTIONS:,}."
    elif values > limits.values:
        message = f"The document has {values:,} values; the limit is {limits.values:,}."
    else:
        return None
    return Finding("R014", "error", message, name, 1, 1)


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


# -- YAML ---------------------------------------------------------------------------------------------------------


class _YamlPlaces:
    """Places of values in YAML. A mapping is indexed when it is first looked into: it may have many keys."""

    def __init__(self, root: Node | None) -> None:
        self._root = root
        self._pairs: dict[int, dict[str, tuple[Node, Node]]] = {}

    def __call__(self, pointer: Pointer, *, of_key: bool = False) -> Place:
        if self._root is None:
            return (0, 0)
        found = position(self._root)
        node = self._root
        for part in pointer:
            step = self._step(node, part)
            if step is None:
                break
            key, node = step
            found = position(key if of_key or isinstance(node, CollectionNode) else node)
        return found

    def _step(self, node: Node, part: str | int) -> tuple[Node, Node] | None:
        """The key and the value that a part of a pointer leads to; an item of a sequence is its own key."""
        if isinstance(node, SequenceNode) and isinstance(part, int) and part < len(node.value):
            return node.value[part], node.value[part]
        if not isinstance(node, MappingNode) or not isinstance(part, str):
            return None
        if id(node) not in self._pairs:
            pairs = ((key, value) for key, value in merged_pairs(node) if isinstance(key, ScalarNode))
            self._pairs[id(node)] = {key.value: (key, value) for key, value in pairs}
        return self._pairs[id(node)].get(part)


def _yaml_duplicates(root: Node, name: str) -> Iterator[Finding]:
    waiting, seen = [root], set()
    while waiting:
        node = waiting.pop()
        if id(node) in seen or not isinstance(node, CollectionNode):
            continue
        seen.add(id(node))
        if isinstance(node, MappingNode):
            yield from (_duplicate(key.value, name, position(key)) for key in duplicate_keys(node))
            waiting.extend(value for _, value in node.value)
        else:
            waiting.extend(node.value)


def _duplicate(key: str, name: str, place: Place, pointer: str = "") -> Finding:
    message = f"Key {key!r} is given twice; only the last one counts."
    return Finding("R006", "error", message, name, *place, pointer=pointer, fix="Remove one of the two.")


# -- JSON ---------------------------------------------------------------------------------------------------------


def _decoded(data: bytes, name: str, limits: Limits) -> tuple[str, Finding | None]:
    if len(data) > limits.file_bytes:
        message = f"The file has {len(data):,} bytes; the limit is {limits.file_bytes:,}."
        return "", Finding("R003", "error", message, name)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        column = error.start - data.rfind(b"\n", 0, error.start)
        message = f"Byte 0x{data[error.start]:02X} is not UTF-8."
        return "", Finding("R002", "error", message, name, line, column, fix="Save the file as UTF-8.")
    return text, None


def _depth(value: Any) -> int:
    """How many collections stand inside each other."""
    depth, level = 0, [value] if isinstance(value, dict | list) else []
    while level:
        depth += 1
        inner = (each for outer in level for each in (outer.values() if isinstance(outer, dict) else outer))
        level = [each for each in inner if isinstance(each, (dict, list))]
    return depth


def _too_deep(text: str, limit: int, name: str) -> Finding:
    """The finding at the first bracket beyond the limit."""
    depth = offset = 0
    for token in _TOKEN.finditer(text):
        depth += (token[0] in ("[", "{")) - (token[0] in ("]", "}"))
        if depth > limit:
            offset = token.start()
            break
    message = f"Collections nest deeper than {limit} levels."
    return Finding("R004", "error", message, name, *_line_and_column(text, offset))


class _NoNumber(ValueError):
    """A number that JSON does not have, or that no computer holds."""


def _parsed(text: str, name: str, nesting: int) -> tuple[Any, list[Finding]]:
    has_duplicates = False

    def as_object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        nonlocal has_duplicates
        value = dict(pairs)
        has_duplicates = has_duplicates or len(value) < len(pairs)
        return value

    try:
        value = json.loads(text, object_pairs_hook=as_object, parse_float=_finite, parse_constant=_no_number)
    except json.JSONDecodeError as error:
        message = f"Not valid JSON: {error.msg[:1].lower()}{error.msg[1:]}."
        return None, [Finding("F001", "error", message, name, error.lineno, error.colno)]
    except _NoNumber as error:
        place = _line_and_column(text, _token_offset(text, str(error)))
        return None, [Finding("F001", "error", f"Not valid JSON: {str(error)[:40]} is no number.", name, *place)]
    except ValueError:
        return None, [Finding("F001", "error", "A number has more digits than can be read.", name)]
    except RecursionError:
        return None, [_too_deep(text, nesting, name)]
    if _depth(value) > nesting:
        return None, [_too_deep(text, nesting, name)]
    return value, list(_json_duplicates(text, name)) if has_duplicates else []


def _finite(text: str) -> float:
    number = float(text)
    return number if math.isfinite(number) else _no_number(text)


def _no_number(text: str) -> float:
    raise _NoNumber(text)


def _token_offset(text: str, wanted: str) -> int:
    return next((token.start() for token in _TOKEN.finditer(text) if token[0] == wanted), 0)


_Spots = dict[str | int, tuple[int, "_Spots", int]]
"""Where values start, as offsets, by key or position; each with the same of the values in it, and where its key starts."""
_NOTHING: _Spots = {}


def _spots(text: str) -> tuple[_Spots, list[tuple[Pointer, int]]]:
    """Where every value of valid JSON starts, the whole under the empty name; and every key that stood there before."""
    here: _Spots = {}
    key: str | int = ""
    key_start = 0
    above: list[tuple[_Spots, str | int]] = []
    repeated: list[tuple[Pointer, int]] = []
    for token in _TOKEN.finditer(text):
        word = token[0]
        if token[2]:
            quoted: str = token[1]
            key, key_start = quoted[1:-1] if "\\" not in quoted else json.loads(quoted), token.start()
            if key in here:
                repeated.append(((*(name for _, name in above[1:]), key), token.start()))
        elif word in ("}", "]"):
            here, key = above.pop()
        else:
            key = key + 1 if isinstance(key, int) else key
            inner: _Spots = {} if word in ("{", "[") else _NOTHING
            here[key] = (token.start(), inner, key_start if isinstance(key, str) else token.start())
            if inner is not _NOTHING:
                above.append((here, key))
                here, key = inner, "" if word == "{" else -1
    return here, repeated


def _json_duplicates(text: str, name: str) -> Iterator[Finding]:
    for pointer, offset in _spots(text)[1]:
        yield _duplicate(str(pointer[-1]), name, _line_and_column(text, offset), pointer_text(pointer))


class _JsonPlaces:
    """Places of values in valid JSON, worked out when the first is asked for."""

    def __init__(self, text: str) -> None:
        self._text = text

    def __call__(self, pointer: Pointer, *, of_key: bool = False) -> Place:
        if not self._text:
            return (0, 0)
        value, inner, key = self._root
        for part in pointer:
            if part not in inner:
                break
            value, inner, key = inner[part]
        offset = key if of_key else value
        line = bisect_right(self._lines, offset)
        return line, offset - self._lines[line - 1] + 1

    @cached_property
    def _root(self) -> tuple[int, _Spots, int]:
        return _spots(self._text)[0][""]

    @cached_property
    def _lines(self) -> list[int]:
        """Offset of the start of every line."""
        return [0, *(match.end() for match in re.finditer("\n", self._text))]


def _line_and_column(text: str, offset: int) -> Place:
    return text.count("\n", 0, offset) + 1, offset - text.rfind("\n", 0, offset)
