"""Function files of either kind, as the functions that an integration starts from."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.file_kind import is_json
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.build.build import build
from sigcat.function.checks.validate import validated
from sigcat.function.declaration.declaration import Declared, read_declaration
from sigcat.function.document.document import Document, read_json
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.sets.sets import with_definitions
from sigcat.limits import DEFAULT_LIMITS, Limits


class ReadFunctions(NamedTuple):
    """Functions, and the warnings of their files."""

    functions: tuple[FunctionJson, ...]
    findings: tuple[Finding, ...]


@collector_paused()
def read_functions(
    files: Sequence[tuple[bytes, str]], catalogue: Callable[[], Catalogue], limits: Limits = DEFAULT_LIMITS
) -> ReadFunctions:
    """The functions of files, `function.yaml` or Function JSON. What one defines, the others may use.

    Only `function.yaml` needs a catalogue. Raises InputRefused with every finding of every file if there are errors.
    """
    read = [
        read_json(data, name, limits) if is_json(data, name) else read_declaration(data, name, limits)
        for data, name in files
    ]
    declared = [each for each in read if isinstance(each, Declared)]
    over = with_definitions(declared, catalogue()) if declared else None
    made = [_of_json(each) if isinstance(each, Document) else _of_declaration(each, over) for each in read]
    findings = in_order([finding for _, found in made for finding in found])
    functions = tuple(function for function, _ in made if function is not None)
    if has_errors(findings) or len(functions) < len(made):
        refused = [name for (_, name), (_, found) in zip(files, made, strict=True) if has_errors(found)]
        message = (
            f"{', '.join(refused[:5])} cannot be integrated: {'it has' if len(refused) == 1 else 'they have'} errors."
        )
        raise InputRefused(message, findings)
    return ReadFunctions(functions, findings)


def _of_json(document: Document) -> tuple[FunctionJson | None, tuple[Finding, ...]]:
    """Integration JSON for ROS 2 is Function JSON with more, and would be taken for a function."""
    function, findings = validated(document, None)
    if function is not None and "CommunicationList" in (function.model_extra or {}):
        message = "This is Integration JSON already; functions are integrated from Function JSON or function.yaml."
        place = document.place(("CommunicationList",))
        found = codes.FIELD_UNKNOWN.finding(message, document.name, *place, pointer="/CommunicationList")
        return None, (*findings, found)
    return function, findings


def _of_declaration(declared: Declared, over: Catalogue | None) -> tuple[FunctionJson | None, tuple[Finding, ...]]:
    assert over is not None
    return build(declared, over)
