"""JSON file of values that functions keep from one run to the next: parameters, error counts, the ignition cycle."""

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.host.connections import Member
from sigcat.adapter.host.kept import Kept
from sigcat.adapter.host.shapes import Value
from sigcat.errors import UsageError
from sigcat.runs.recording.cells import Literal, Unfit, exact_float, fitted, json_text

Stored = Mapping[Kept, Value]
_NAMES = 3
"""Function, section, and the name within it."""


def stored_text(stored: Stored, members: Sequence[Member], others: Mapping[str, Any]) -> str:
    """The file: by function, then by section, then by name. `others` is what functions that did not run keep."""
    document: dict[str, Any] = {**others}
    for each, value in stored.items():
        section = document.setdefault(members[each.member].name, {})
        found = json.loads(json_text(value, each.shape))
        if each.name:
            section.setdefault(each.section, {})[each.name] = found
        else:
            section[each.section] = found
    return f"{_text(document, 0)}\n"


def _text(value: Any, depth: int) -> str:
    """A value of JSON as `json.dumps` writes it with an indent of 2; numbers that others wrote keep their digits."""
    inner = "\n" + "  " * (depth + 1)
    if isinstance(value, Mapping) and value:
        fields = (f"{json.dumps(key, ensure_ascii=False)}: {_text(each, depth + 1)}" for key, each in value.items())
        return f"{{{inner}{f',{inner}'.join(fields)}{inner[:-2]}}}"
    if isinstance(value, list) and value:
        return f"[{inner}{f',{inner}'.join(_text(each, depth + 1) for each in value)}{inner[:-2]}]"
    return value.text if isinstance(value, Literal) else json.dumps(value, ensure_ascii=False)


class StoredFile(NamedTuple):
    """Content of a file."""

    values: Stored
    """Values of the functions of the run."""
    others: Mapping[str, Any]
    """Values of all other functions, unchanged."""


_MISSING = object()
EMPTY = StoredFile({}, {})
"""A file that is not there yet."""


def read_stored(data: bytes, name: str, kept: Sequence[Kept], members: Sequence[Member]) -> StoredFile:
    """The values of a file. Raises UsageError, also for what a function of the run does not keep: it would be lost."""
    try:
        document = json.loads(data, parse_float=exact_float)
    except (ValueError, RecursionError):
        document = None
    if not isinstance(document, dict):
        raise UsageError(f"{name} must be a JSON object, such as a run with --stored writes it")
    running = {member.name for member in members}
    _refuse_unknown(document, name, kept, members)
    others = {function: section for function, section in document.items() if function not in running}
    return StoredFile(dict(_values(document, name, kept, members)), others)


def _refuse_unknown(document: Mapping[str, Any], name: str, kept: Sequence[Kept], members: Sequence[Member]) -> None:
    known = {(members[each.member].name, each.section, *([each.name] if each.name else [])) for each in kept}
    for member in members:
        for path in _paths(document.get(member.name, {}), (member.name,)):
            if len(path) == 1 and not isinstance(document.get(member.name, {}), Mapping):
                raise UsageError(f"{name}: {member.name} must be an object, as a run with --stored writes it")
            if path not in known:
                raise UsageError(
                    f"{name}: {'/'.join(path)} is not kept by the function. Remove it, or correct its name"
                )


def _paths(value: Any, path: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """The function, the section and, where that has some, the name of everything that is given."""
    if isinstance(value, Mapping) and len(path) < _NAMES:
        for key, below in value.items():
            yield from _paths(below, (*path, key))
    else:
        yield path


def _values(document: Any, name: str, kept: Sequence[Kept], members: Sequence[Member]) -> Iterator[tuple[Kept, Value]]:
    for each in kept:
        path = [members[each.member].name, each.section, *([each.name] if each.name else [])]
        given = _at(document, path)
        if given is _MISSING:
            continue
        try:
            yield each, fitted(given, each.shape)
        except Unfit as reason:
            raise UsageError(f"{name}: {'/'.join(path)} {reason}") from None


def _at(document: Any, path: Sequence[str]) -> Any:
    for key in path:
        document = document.get(key, _MISSING) if isinstance(document, Mapping) else _MISSING
    return document
