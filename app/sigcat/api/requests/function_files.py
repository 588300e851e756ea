"""Function files in the body of a request: one as it stands, or a set in a JSON object."""

import json
from collections.abc import Mapping
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.document.read_json import read_json
from sigcat.limits import REQUEST_FUNCTIONS, Limits

SET = "a JSON object with `functions`, a list of Function JSON objects and of texts of `function.yaml`"

File = tuple[bytes, str]
"""Content and name."""


class PostedFunctions(NamedTuple):
    """The files of a body."""

    files: tuple[File, ...]
    deployment: File | None
    is_set: bool


def posted_functions(text: bytes, name: str, limits: Limits, *, deployment: bool = False) -> PostedFunctions:
    """The files of a body; with `deployment`, a set may have one. Raises InputRefused if it is no set and no file."""
    parts = _set_of(text, name, limits, ("functions", "deployment") if deployment else ("functions",))
    if parts is None:
        return PostedFunctions(((text, name),), None, is_set=False)
    files = tuple(_file(part, f"{name}, function {number}") for number, part in enumerate(parts["functions"], 1))
    stated = parts.get("deployment")
    return PostedFunctions(files, None if stated is None else _file(stated, f"{name}, deployment"), is_set=True)


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
    if unknown or not isinstance(given, list) or not 1 <= len(given) <= REQUEST_FUNCTIONS:
        more = ", and `deployment` if wanted" if "deployment" in keys else ""
        message = f"A set has `functions`, a list of 1 to {REQUEST_FUNCTIONS}{more}; nothing else."
        at = (unknown[0],) if unknown else ("functions",)
        raise InputRefused(message, (document.finding(codes.FIELD_UNKNOWN, at, message),))
    return value


def _file(part: Any, name: str) -> File:
    """A part of a set as the bytes of its file: a text is YAML, anything else JSON."""
    if isinstance(part, str):
        return part.encode("utf-8", "replace"), f"{name}.yaml"
    return json.dumps(part).encode(), f"{name}.json"
