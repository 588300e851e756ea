"""JSON with positions: bytes in, a document out."""

import json
import math
import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import cached_property
from itertools import islice
from typing import Any

from sigcat import codes
from sigcat.catalogue.reading.whole_numbers import whole_number
from sigcat.digest import digest_of
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, Position, pointer_text
from sigcat.function.document.duplicates import duplicate_key
from sigcat.function.document.size import too_crowded
from sigcat.limits import DEFAULT_LIMITS, Limits

_TOKEN = re.compile(r'("(?:[^"\\]|\\.)*+(?:"|\\?\Z))(\s*:)?|[\[\]{}]|[^\s\[\]{},:"]++', re.DOTALL)
"""Keys with their colon, and values, of JSON; an unterminated text runs to the end, so that the search stays linear."""


def read_json(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Document:
    """Read JSON as RFC 8259 has it: no NaN, no key twice, UTF-8."""
    crowded = too_crowded(data, name, limits, (b"{", b"["))
    text, finding = ("", crowded) if crowded is not None else _decoded(data, name, limits)
    value = None
    findings = [finding] if finding else []
    if not findings:
        value, findings = _parsed(text, name, limits.nesting)
    return Document(name, digest_of(data), value, tuple(findings), _JsonPositions(text if value is not None else ""))


def _decoded(data: bytes, name: str, limits: Limits) -> tuple[str, Finding | None]:
    if len(data) > limits.file_bytes:
        message = f"The file has {len(data):,} bytes; the limit is {limits.file_bytes:,}."
        return "", codes.FILE_TOO_LARGE.finding(message, name)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        column = error.start - data.rfind(b"\n", 0, error.start)
        message = f"Byte 0x{data[error.start]:02X} is not UTF-8."
        return "", codes.NOT_UTF_8.finding(message, name, line, column, fix="Save the file as UTF-8.")
    return text, None


def _depth(value: Any) -> int:
    """Depth of nested collections."""
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
    return codes.NESTING_TOO_DEEP.finding(message, name, *_line_and_column(text, offset))


_SURROGATES = re.compile(
    r"\\\\|\\u[dD][89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F][0-9a-fA-F]{2}|(?P<half>\\u[dD][89a-fA-F][0-9a-fA-F]{2})"
)
"""Escaped backslashes, characters in two halves, and halves alone, which no encoding of a file can hold."""


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
        value = json.loads(
            text, object_pairs_hook=as_object, parse_float=_finite, parse_int=whole_number, parse_constant=_no_number
        )
    except json.JSONDecodeError as error:
        message = f"Not valid JSON: {error.msg[:1].lower()}{error.msg[1:]}."
        if not text[: error.pos].strip():
            message = "The document must be JSON." if text.strip() else "The document must be JSON, and it is empty."
        return None, [codes.NOT_JSON.finding(message, name, error.lineno, error.colno)]
    except _NoNumber as error:
        position = _line_and_column(text, _token_offset(text, str(error)))
        return None, [codes.NOT_JSON.finding(f"Not valid JSON: {str(error)[:40]} is not a number.", name, *position)]
    except ValueError:
        return None, [codes.NOT_JSON.finding("A number is too large, or has more digits than can be read.", name)]
    except RecursionError:
        return None, [_too_deep(text, nesting, name)]
    if _depth(value) > nesting:
        return None, [_too_deep(text, nesting, name)]
    halves = list(islice(_halves(text, name), 1)) if "\\u" in text else ()
    return (None, halves) if halves else (value, list(_duplicates(text, name)) if has_duplicates else [])


def _halves(text: str, name: str) -> Iterator[Finding]:
    for found in _SURROGATES.finditer(text):
        if found["half"]:
            message = f"Not valid JSON: {found['half']} is half of a character. Write both halves, or none."
            yield codes.NOT_JSON.finding(message, name, *_line_and_column(text, found.start()))


def _finite(text: str) -> float:
    number = float(text)
    return number if math.isfinite(number) else _no_number(text)


def _no_number(text: str) -> float:
    raise _NoNumber(text)


def _token_offset(text: str, wanted: str) -> int:
    return next((token.start() for token in _TOKEN.finditer(text) if token[0] == wanted), 0)


_Offsets = dict[str | int, tuple[int, "_Offsets", int]]
"""Offsets of values, by key or index; each with the same of the values in it, and the offset of its key."""
_NOTHING: _Offsets = {}


def _offsets(text: str) -> tuple[_Offsets, list[tuple[Pointer, int, int]]]:
    """Offset of every value of valid JSON, the whole under the empty name; and repeated keys, each with the offset
    of the key before it."""
    here: _Offsets = {}
    key: str | int = ""
    key_start = 0
    above: list[tuple[_Offsets, str | int]] = []
    repeated: list[tuple[Pointer, int, int]] = []
    for token in _TOKEN.finditer(text):
        word = token[0]
        if token[2]:
            quoted: str = token[1]
            key, key_start = quoted[1:-1] if "\\" not in quoted else json.loads(quoted), token.start()
            if key in here:
                repeated.append(((*(name for _, name in above[1:]), key), token.start(), here[key][2]))
        elif word in ("}", "]"):
            here, key = above.pop()
        else:
            key = key + 1 if isinstance(key, int) else key
            inner: _Offsets = {} if word in ("{", "[") else _NOTHING
            here[key] = (token.start(), inner, key_start if isinstance(key, str) else token.start())
            if inner is not _NOTHING:
                above.append((here, key))
                here, key = inner, "" if word == "{" else -1
    return here, repeated


def _duplicates(text: str, name: str) -> Iterator[Finding]:
    for pointer, offset, first in _offsets(text)[1]:
        place, before = _line_and_column(text, offset), _line_and_column(text, first)
        yield duplicate_key(str(pointer[-1]), name, place, before, pointer_text(pointer))


class _JsonPositions:
    """Positions of values in valid JSON, worked out when the first is asked for."""

    def __init__(self, text: str) -> None:
        self._text = text

    def __call__(self, pointer: Pointer, *, of_key: bool = False) -> Position:
        if not self._text:
            return Position()
        value, inner, key = self._root
        for part in pointer:
            if part not in inner:
                break
            value, inner, key = inner[part]
        offset = key if of_key else value
        line = bisect_right(self._lines, offset)
        return Position(line, offset - self._lines[line - 1] + 1)

    @cached_property
    def _root(self) -> tuple[int, _Offsets, int]:
        return _offsets(self._text)[0][""]

    @cached_property
    def _lines(self) -> list[int]:
        """Offset of the start of every line."""
        return [0, *(match.end() for match in re.finditer("\n", self._text))]


def _line_and_column(text: str, offset: int) -> Position:
    return Position(text.count("\n", 0, offset) + 1, offset - text.rfind("\n", 0, offset))
