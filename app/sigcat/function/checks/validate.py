"""Function JSON from anywhere: is it valid, is it consistent, does it follow the conventions?"""

import re
from typing import NamedTuple

from pydantic import BaseModel, ValidationError

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import Finding, in_order
from sigcat.function.checks.checks import check
from sigcat.function.checks.conventions import check_conventions
from sigcat.function.document.document import Document, Pointer, pointer_text, read_json
from sigcat.function.document.problem import Problem
from sigcat.function.document.severities import SEVERITIES
from sigcat.function.document.structure import fields_of, models_of, structural_findings
from sigcat.function.function_json.model import FunctionJson
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import nearest

_MAJOR = re.compile(r"\s*[vV]?(\d{1,9})(?:\.|\s*\Z)")
_READ = 1
"""The major version of the format that is read."""


class Validated(NamedTuple):
    """A document that was validated: the function, unless its structure is wrong, and everything to be said."""

    function: FunctionJson | None
    findings: tuple[Finding, ...]


@collector_paused()
def validate_function_json(
    data: bytes, name: str, catalogue: Catalogue | None = None, limits: Limits = DEFAULT_LIMITS
) -> tuple[Finding, ...]:
    """Everything that is wrong with a Function JSON. Errors make it unusable; warnings are departures from conventions.

    With a catalogue, units, paths and ranges are compared with it.
    """
    return read_function_json(data, name, catalogue, limits).findings


@collector_paused()
def read_function_json(
    data: bytes, name: str, catalogue: Catalogue | None = None, limits: Limits = DEFAULT_LIMITS
) -> Validated:
    """The function of a document, and everything that is wrong with it."""
    return validated(read_json(data, name, limits), catalogue)


@collector_paused()
def validated(document: Document, catalogue: Catalogue | None) -> Validated:
    """The function of a document that was read, and everything that is wrong with it."""
    if document.value is None and document.findings:
        return Validated(None, document.findings)
    other = _other_version(document)
    if other is not None:
        return Validated(None, (other,))
    try:
        function = FunctionJson.model_validate(document.value, by_name=False)
    except ValidationError as error:
        findings = (*document.findings, *structural_findings(error, document, FunctionJson))
        return Validated(None, in_order(findings))
    return Validated(function, _judged(function, document, catalogue))


def _other_version(document: Document) -> Finding | None:
    """A finding instead of many, where the document is of another major version of the format."""
    meta = document.value.get("MetaInfo") if isinstance(document.value, dict) else None
    version = meta.get("SchemaVersion") if isinstance(meta, dict) else None
    major = _MAJOR.match(str(version)) if isinstance(version, str | int | float) else None
    if major is None or int(major[1]) == _READ:
        return None
    at = ("MetaInfo", "SchemaVersion")
    message = f"The document is of version {str(version)[:40]} of the format; this program reads version {_READ}."
    is_newer = int(major[1]) > _READ
    fix = "Use a newer sigcat, or write the document as version 1." if is_newer else "Write the document as version 1."
    return Finding("F005", SEVERITIES["F005"], message, document.name, *document.place(at), "", pointer_text(at), fix)


def _judged(function: FunctionJson, document: Document, catalogue: Catalogue | None) -> tuple[Finding, ...]:
    problems = [*check(function, _known_errors(catalogue)), *check_conventions(function, catalogue)]
    findings = (*document.findings, *(_finding(problem, document) for problem in problems), *_unknown_keys(document))
    return in_order(findings)


def _known_errors(catalogue: Catalogue | None) -> frozenset[str]:
    nodes = catalogue.nodes if catalogue else ()
    return frozenset(interface_name(path) for path in nodes if category_of(path) == "error")


def _finding(problem: Problem, document: Document) -> Finding:
    place = document.place(problem.pointer)
    pointer = pointer_text(problem.pointer)
    severity = SEVERITIES[problem.rule]
    return Finding(problem.rule, severity, problem.message, document.name, *place, problem.path, pointer, problem.fix)


def _unknown_keys(document: Document) -> list[Finding]:
    """Keys that no model knows but that are near one it does: probably misspelled."""
    found: list[Finding] = []
    waiting: list[tuple[Pointer, object, type[BaseModel]]] = [((), document.value, FunctionJson)]
    while waiting:
        pointer, value, model = waiting.pop()
        if isinstance(value, list):
            waiting.extend(((*pointer, i), item, model) for i, item in enumerate(value))
        elif isinstance(value, dict):
            models = models_of(model)
            if not models.keys() >= value.keys():
                found.extend(_misspelled(pointer, value, model, document))
            for key, inner in models.items():
                if inner is not None and isinstance(value.get(key), dict | list):
                    waiting.append(((*pointer, key), value[key], inner))
    return found


def _misspelled(
    pointer: Pointer, value: dict[str, object], model: type[BaseModel], document: Document
) -> list[Finding]:
    known = fields_of(model)
    found = []
    for key in value:
        meant = nearest(key, [k for k in known if k not in value], limit=1) if key not in known else ()
        if meant:
            at = (*pointer, key)
            message = f"{key!r} is no key of Function JSON and is not looked at."
            place, text = document.place(at, of_key=True), pointer_text(at)
            fix = f"Did you mean {meant[0]!r}?"
            found.append(Finding("F003", "warning", message, document.name, *place, "", text, fix))
    return found
