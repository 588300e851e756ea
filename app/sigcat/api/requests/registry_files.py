"""Files in the body of a request to the registry: one unchanged, or several in a JSON object."""

from typing import Any

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.document.read_json import read_json
from sigcat.limits import NAME_CHARACTERS, REQUEST_FUNCTIONS, Limits
from sigcat.registry.posted import File

FILES = 'a JSON object with `files`, a list of objects such as {"name": "Meter.function.yaml", "text": "…"}'


def registry_files(body: bytes, name: str, limits: Limits) -> tuple[File, ...]:
    """The files of a body. Raises InputRefused."""
    if body.lstrip()[:1] != b"{" or b'"files"' not in body:
        return ((body, name),)
    document = read_json(body, name, limits)
    if has_errors(document.findings):
        raise InputRefused(f"{name} cannot be read.", document.findings)
    value = document.value
    if not isinstance(value, dict) or set(value) != {"files"}:
        return ((body, name),)
    files = value["files"]
    if not (isinstance(files, list) and 1 <= len(files) <= REQUEST_FUNCTIONS and all(map(_is_file, files))):
        message = f"`files` must be a list of 1 to {REQUEST_FUNCTIONS} objects with `name` and `text`, both texts."
        raise InputRefused(message, (document.finding(codes.FIELD_UNKNOWN, ("files",), message),))
    return tuple((each["text"].encode("utf-8", "replace"), each["name"]) for each in files)


def _is_file(value: Any) -> bool:
    is_file = isinstance(value, dict) and value.keys() == {"name", "text"}
    return is_file and all(isinstance(part, str) for part in value.values()) and len(value["name"]) <= NAME_CHARACTERS
