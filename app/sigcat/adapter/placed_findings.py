"""Findings about a document that was read long before: with its name, and the line and column of their pointers."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer
from sigcat.function.document.read_json import read_json
from sigcat.limits import Limits


@contextmanager
def placed_in(data: bytes, name: str, limits: Limits) -> Iterator[None]:
    """Give findings that have a pointer alone their place in the document."""
    try:
        yield
    except InputRefused as refused:
        document = read_json(data, name, limits)
        findings = tuple(each if each.file else _placed(each, document) for each in refused.findings)
        raise InputRefused(str(refused), findings) from refused


def _placed(finding: Finding, document: Document) -> Finding:
    line, column = document.position(_pointer(finding.pointer, document.value))
    return finding._replace(file=document.name, line=line, column=column)


def _pointer(text: str, value: Any) -> Pointer:
    """The keys and indexes of a pointer, as far as they lead."""
    found: list[str | int] = []
    for part in text.split("/")[1:]:
        key: str | int = part.replace("~1", "/").replace("~0", "~")
        if isinstance(value, list) and part.isdigit() and int(part) < len(value):
            key = int(part)
        elif not isinstance(value, dict) or key not in value:
            break
        value = value[key]
        found.append(key)
    return tuple(found)
