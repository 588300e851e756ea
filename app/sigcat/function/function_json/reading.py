"""Function JSON from anywhere: a document in, the resolved function out, or the errors of its structure."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from pydantic import ValidationError

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.document.document import Document
from sigcat.function.document.near_keys import near_keys
from sigcat.function.document.structure import structural_findings
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction

_MAJOR = re.compile(r"\s*[vV]?(\d{1,9})(?:\.|\s*\Z)")
_READ = 1
"""The major version of the format that is read."""


class ReadFunction(NamedTuple):
    """The function of a document, None if its structure is wrong, and the findings of the structure."""

    resolved: ResolvedFunction | None
    findings: tuple[Finding, ...]


def read_function(document: Document) -> ReadFunction:
    """The function that a document holds as Function JSON."""
    if document.value is None and document.findings:
        return ReadFunction(None, document.findings)
    other = _other_version(document)
    if other is not None:
        return ReadFunction(None, (other,))
    try:
        function = FunctionJson.model_validate(document.value, by_name=False)
    except ValidationError as error:
        return ReadFunction(None, (*document.findings, *structural_findings(error, document, FunctionJson)))
    return ReadFunction(ResolvedFunction(function, document), (*document.findings, *_unknown_keys(document)))


def _other_version(document: Document) -> Finding | None:
    """A finding instead of many, where the document is of another major version of the format."""
    meta = document.value.get("MetaInfo") if isinstance(document.value, dict) else None
    version = meta.get("SchemaVersion") if isinstance(meta, dict) else None
    major = _MAJOR.match(str(version)) if isinstance(version, str | int | float) else None
    if major is None or int(major[1]) == _READ:
        return None
    message = f"The version of the format must be {_READ}, not {str(version)[:40]}."
    newer = "Use a newer sigcat, or write" if int(major[1]) > _READ else "Write"
    fix = f"{newer} the document as version {_READ}."
    return document.finding(codes.SCHEMA_VERSION_UNKNOWN, ("MetaInfo", "SchemaVersion"), message, fix)


_IGNORED = codes.FIELD_UNKNOWN.graded("warning")
"""The published schema allows further keys, so that a document with one is valid: only its value is lost."""


def _unknown_keys(document: Document) -> Iterator[Finding]:
    for pointer, key, meant, is_meant_there in near_keys(document.value, FunctionJson):
        message = f"Unknown key {key!r}; its value is ignored."
        fix = f"Remove it, or {meant!r}." if is_meant_there else f"Did you mean {meant!r}?"
        yield document.finding(_IGNORED, pointer, message, fix, of_key=True)
