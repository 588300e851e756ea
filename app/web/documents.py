"""The documents that are made from a function, each to be read, copied and downloaded."""

from typing import NamedTuple

from app.function.model import FunctionJson, to_json


class MadeDocument(NamedTuple):
    """A document."""

    id: str
    """Name in addresses."""
    title: str
    file: str
    """Name of the file when it is downloaded."""
    media_type: str
    text: str


def documents_of(function: FunctionJson) -> tuple[MadeDocument, ...]:
    """Every document of a function."""
    name = function.info.function_name
    text = to_json(function).decode("utf-8", "replace")
    return (MadeDocument("function-json", "Function JSON", f"{name}.json", "application/json", text),)
