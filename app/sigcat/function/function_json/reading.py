"""Function JSON from anywhere: a document in, the resolved function out, or what is wrong with its structure."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from pydantic import BaseModel, ValidationError

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer
from sigcat.function.document.structure import fields_of, models_of, structural_findings
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.names import nearest

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


def _unknown_keys(document: Document) -> Iterator[Finding]:
    """Keys that no model knows but that are near one it does: probably misspelled."""
    waiting: list[tuple[Pointer, object, type[BaseModel]]] = [((), document.value, FunctionJson)]
    while waiting:
        pointer, value, model = waiting.pop()
        if isinstance(value, list):
            waiting.extend(((*pointer, i), item, model) for i, item in enumerate(value))
        elif isinstance(value, dict):
            models = models_of(model)
            if not models.keys() >= value.keys():
                yield from _misspelled(pointer, value, model, document)
            for key, inner in models.items():
                if inner is not None and isinstance(value.get(key), dict | list):
                    waiting.append(((*pointer, key), value[key], inner))


_IGNORED = codes.FIELD_UNKNOWN.graded("warning")
"""The published schema allows further keys, so that a document with one is valid: only its value is lost."""


def _misspelled(
    pointer: Pointer, value: dict[str, object], model: type[BaseModel], document: Document
) -> Iterator[Finding]:
    known = fields_of(model)
    for key in value:
        meant = nearest(key, [k for k in known if k not in value], limit=1) if key not in known else ()
        if meant:
            message = f"Unknown key {key!r}; its value is ignored."
            yield document.finding(_IGNORED, (*pointer, key), message, f"Did you mean {meant[0]!r}?", of_key=True)
