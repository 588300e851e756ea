"""What functions keep from one run to the next, as a file of JSON: parameters, counts of errors, the ignition cycle."""

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sigcat.errors import UsageError
from sigcat.runs.connections import Member
from sigcat.runs.kept import Kept
from sigcat.runs.recording.cells import Unfit, fitted, json_text
from sigcat.runs.recording.shapes import Value

Stored = Mapping[Kept, Value]


def stored_text(stored: Stored, members: Sequence[Member]) -> str:
    """The file: by function, then by section, then by name."""
    document: dict[str, Any] = {}
    for each, value in stored.items():
        section = document.setdefault(members[each.member].name, {})
        found = json.loads(json_text(value, each.shape))
        if each.name:
            section.setdefault(each.section, {})[each.name] = found
        else:
            section[each.section] = found
    return f"{json.dumps(document, indent=2, ensure_ascii=False)}\n"


def read_stored(data: bytes, name: str, kept: Sequence[Kept], members: Sequence[Member]) -> dict[Kept, Value]:
    """The values of a file. What functions do not keep any more is left out. Raises UsageError."""
    try:
        document = json.loads(data)
    except (ValueError, RecursionError):
        raise UsageError(f"{name} must be JSON, such as a run with --stored writes it") from None
    return dict(_values(document, name, kept, members))


def _values(document: Any, name: str, kept: Sequence[Kept], members: Sequence[Member]) -> Iterator[tuple[Kept, Value]]:
    for each in kept:
        path = [members[each.member].name, each.section, *([each.name] if each.name else [])]
        given = _at(document, path)
        if given is None:
            continue
        try:
            yield each, fitted(given, each.shape)
        except Unfit as reason:
            raise UsageError(f"{name}: {'/'.join(path)} {reason}") from None


def _at(document: Any, path: Sequence[str]) -> Any:
    for key in path:
        document = document.get(key) if isinstance(document, Mapping) else None
    return document
