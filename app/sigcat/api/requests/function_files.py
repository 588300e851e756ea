"""Function files in the body of a request: one file unchanged, or a set in a JSON object."""

import json
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.document.read_json import read_json
from sigcat.limits import REQUEST_FUNCTIONS, Limits

SET = "a JSON object with `functions`, a list of Function JSON objects and of texts of `function.yaml`"

_FURTHER = {
    "deployment": "`deployment`",
    "identifiers": "`identifiers`, a list of texts,",
    "previous": "`previous`, an Integration JSON,",
}
File = tuple[bytes, str]
"""Content and name."""


class PostedFunctions(NamedTuple):
    """The files of a body."""

    files: tuple[File, ...]
    deployment: File | None
    is_set: bool
    identifiers: tuple[File, ...] = ()
    """Id catalogues, as CSV or ARXML."""
    previous: File | None = None
    """The Integration JSON before."""


def posted_functions(text: bytes, name: str, limits: Limits, *, further: Sequence[str] = ()) -> PostedFunctions:
    """The files of a body; a set may have `further` keys: `deployment`, `identifiers`, `previous`. Raises InputRefused."""
    parts = _set_of(text, name, limits, ("functions", *further))
    if parts is None:
        return PostedFunctions(((text, name),), None, is_set=False)
    files = tuple(_file(part, f"{name}, function {number}") for number, part in enumerate(parts["functions"], 1))
    stated = parts.get("deployment")
    deployment = None if stated is None else _file(stated, f"{name}, deployment")
    catalogues = enumerate(parts.get("identifiers", ()), 1)
    identifiers = tuple(
        (part.encode("utf-8", "replace"), f"{name}, identifiers {number}") for number, part in catalogues
    )
    before = parts.get("previous")
    previous = None if before is None else _file(before, f"{name}, previous")
    return PostedFunctions(files, deployment, is_set=True, identifiers=identifiers, previous=previous)


def _set_of(text: bytes, name: str, limits: Limits, keys: tuple[str, ...]) -> Mapping[str, Any] | None:
    """The body, if it is a set: a JSON object with `functions`."""
    if text.lstrip()[:1] != b"{" or b'"functions"' not in text:
        return None
    document = read_json(text, name, limits)
    if has_errors(document.findings):
        raise InputRefused(f"{name} cannot be read.", document.findings)
    value = document.value
    if not isinstance(value, dict) or "functions" not in value:
        return None
    given = value["functions"]
    unknown = sorted(set(value) - set(keys))
    is_right = isinstance(given, list) and 1 <= len(given) <= REQUEST_FUNCTIONS
    if unknown or not is_right or not _are_texts(value.get("identifiers", [])):
        more = "".join(f", {_FURTHER[key]} if needed" for key in keys[1:])
        message = f"A set has `functions`, a list of 1 to {REQUEST_FUNCTIONS}{more}; nothing else."
        at = (unknown[0],) if unknown else ("identifiers",) if is_right else ("functions",)
        raise InputRefused(message, (document.finding(codes.FIELD_UNKNOWN, at, message),))
    return value


def _are_texts(value: Any) -> bool:
    return isinstance(value, list) and len(value) <= REQUEST_FUNCTIONS and all(isinstance(part, str) for part in value)


def _file(part: Any, name: str) -> File:
    """A part of a set as the bytes of its file: a text is YAML, anything else JSON."""
    if isinstance(part, str):
        return part.encode("utf-8", "replace"), f"{name}.yaml"
    return json.dumps(part).encode(), f"{name}.json"
