"""Interfaces that Function JSON carries, since its declaration defined them: it can be checked where no overlay has them."""

from collections.abc import Iterator
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.document.document import Document, Pointer
from sigcat.function.extension.defined_nodes import DefinedNode, Definitions


def carried_definitions(document: Document, catalogue: Catalogue) -> Definitions:
    """Definitions that a document carries and the catalogue lacks.

    No declaration defines instances, which could make millions of nodes of a line.
    """
    made_from = document.value.get("Provenance") if isinstance(document.value, dict) else None
    if not isinstance(made_from, dict):
        return Definitions()
    return Definitions(*(tuple(_lacking(made_from, key, catalogue)) for key in ("Definitions", "TypeDefinitions")))


def _lacking(made_from: dict[str, Any], key: str, catalogue: Catalogue) -> Iterator[DefinedNode]:
    entries = made_from.get(key)
    for index, entry in enumerate(entries if isinstance(entries, list) else ()):
        path, values = (entry.get("Path"), entry.get("Attributes")) if isinstance(entry, dict) else (None, None)
        if not isinstance(path, str) or not isinstance(values, dict) or "instances" in values:
            continue
        if catalogue.get(path) is None:
            at: Pointer = ("Provenance", key, index, "Attributes")
            yield DefinedNode(path, values, at)
