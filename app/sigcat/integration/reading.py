"""Function files of either kind, as the functions that an integration starts from."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.declaration.declaration import Declared
from sigcat.function.document.document import Document
from sigcat.function.extension.defined_nodes import Definitions
from sigcat.function.extension.extended_catalogue import extended
from sigcat.function.function_file import check_declaration, check_document, read_function_file
from sigcat.function.function_json.model import FunctionJson
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
    read = [read_function_file(data, name, limits) for data, name in files]
    declared = [each for each in read if isinstance(each, Declared)]
    over, definitions = extended(catalogue(), declared) if declared else (None, ())
    own = iter(definitions)
    made = [_of_json(each) if isinstance(each, Document) else _of_declaration(each, next(own), over) for each in read]
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
    checked = check_document(document, None)
    function, findings = checked.function, checked.findings
    if function is not None and "CommunicationList" in (function.model_extra or {}):
        message = "The document must be Function JSON, not Integration JSON, which is integrated already."
        fix = "Give the Function JSON or the function.yaml that it was made from."
        return None, (*findings, document.finding(codes.FIELD_UNKNOWN, ("CommunicationList",), message, fix))
    return function, findings


def _of_declaration(
    declared: Declared, definitions: Definitions, over: Catalogue | None
) -> tuple[FunctionJson | None, tuple[Finding, ...]]:
    assert over is not None
    checked = check_declaration(declared, definitions, over)
    return checked.sound_function, checked.findings
