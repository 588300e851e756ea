"""Function files of either kind, as the resolved functions that an integration starts from."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.errors import InputRefused
from sigcat.file_kind import document_kind
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.declaration.declaration import Declared
from sigcat.function.document.document import Document
from sigcat.function.extension.extended_catalogue import extended
from sigcat.function.function_file import (
    CheckedFunction,
    FunctionFile,
    check_declaration,
    check_document,
    read_function_file,
)
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.limits import DEFAULT_LIMITS, Limits


class ReadFunctions(NamedTuple):
    """Functions, and the warnings of their files."""

    functions: tuple[ResolvedFunction, ...]
    findings: tuple[Finding, ...]


@collector_paused()
def read_functions(
    files: Sequence[tuple[bytes, str]], catalogue: Callable[[], Catalogue], limits: Limits = DEFAULT_LIMITS
) -> ReadFunctions:
    """The functions of files, `function.yaml` or Function JSON. What one defines or carries, the others may use.

    Only `function.yaml` needs a catalogue. Raises InputRefused with every finding of every file if there are errors.
    """
    checked = _checked([read_function_file(data, name, limits) for data, name in files], catalogue)
    findings = in_order([finding for each in checked for finding in each.findings])
    if has_errors(findings):
        refused = [name for (_, name), each in zip(files, checked, strict=True) if has_errors(each.findings)]
        message = (
            f"{', '.join(refused[:5])} cannot be integrated: {'it has' if len(refused) == 1 else 'they have'} errors."
        )
        raise InputRefused(message, findings)
    return ReadFunctions(tuple(each.resolved for each in checked if each.resolved is not None), findings)


def _checked(files: Sequence[FunctionFile], catalogue: Callable[[], Catalogue]) -> list[CheckedFunction]:
    """Each file: a declaration against the catalogue with what all of them define, Function JSON in itself."""
    if not any(isinstance(file, Declared) for file in files):
        return [_of_json(file) for file in files if isinstance(file, Document)]
    over, definitions = extended(catalogue(), files)
    return [
        check_declaration(file, own, over) if isinstance(file, Declared) else _of_json(file)
        for file, own in zip(files, definitions, strict=True)
    ]


def _of_json(document: Document) -> CheckedFunction:
    """Integration JSON for ROS 2 is Function JSON with more, and would be taken for a function."""
    checked = check_document(document, None)
    kind = document_kind(document.value) if checked.function else None
    if kind is None or kind.kind != "integration json":
        return checked
    message = f"The document must be Function JSON, not {kind.title}, which is integrated already."
    fix = "Give the Function JSON or the function.yaml that it was made from."
    finding = document.finding(codes.FIELD_UNKNOWN, (), message, fix)
    return checked._replace(findings=(*checked.findings, finding))
