"""Keys of an Integration JSON that nothing would read: each is near one that is missing, so that its value would be lost."""

from collections.abc import Iterator

from pydantic import BaseModel

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.document.document import Document
from sigcat.function.document.near_keys import near_keys

_CARRIED = "SourceFunctionList"
"""Function JSON as it was given: its own keys were reported when it was integrated."""


def misspelled_keys(document: Document, model: type[BaseModel]) -> Iterator[Finding]:
    """An error for each. Other keys are taken: the document may have more than sigcat knows."""
    for pointer, key, meant, is_meant_there in near_keys(document.value, model):
        if not is_meant_there and pointer[0] != _CARRIED:
            message = f"Unknown key {key!r}; its value would be ignored."
            yield document.finding(codes.FIELD_UNKNOWN, pointer, message, f"Did you mean {meant!r}?", of_key=True)
