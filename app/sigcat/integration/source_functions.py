"""The functions that an Integration JSON was made from: the same field on every platform."""

from collections.abc import Iterator
from typing import Any

from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, Position
from sigcat.function.function_file import check_document
from sigcat.function.function_json.wire import own

SOURCE_FUNCTIONS = "SourceFunctionList"
"""Name of the field on the wire."""


def source_functions() -> Any:
    """The field: `functions: tuple[FunctionJson, ...] | None = source_functions()`."""
    return own(
        SOURCE_FUNCTIONS,
        "The Function JSON of each function that was integrated: what adapters are generated from.",
        strict=False,
    )


def function_document(document: Document, index: int) -> Document:
    """A function of an Integration JSON, as a document whose positions are those in the whole."""
    at: Pointer = (SOURCE_FUNCTIONS, index)

    def position(pointer: Pointer, *, of_key: bool = False) -> Position:
        return document.position((*at, *pointer), of_key=of_key)

    return Document(document.name, "", document.value[SOURCE_FUNCTIONS][index], (), position)


def errors_of_function(document: Document, index: int) -> Iterator[Finding]:
    """Everything that is wrong with a function of an Integration JSON: what `function validate` calls an error."""
    for finding in check_document(function_document(document, index), None).findings:
        if finding.severity == "error":
            yield finding._replace(pointer=f"/{SOURCE_FUNCTIONS}/{index}{finding.pointer}")
