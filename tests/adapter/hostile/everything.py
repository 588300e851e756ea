"""A function with every field, and its documents for every platform."""

import json
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import to_json
from sigcat.integration.reading import read_functions
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS

FUNCTION = Path(__file__).with_name("everything.function.yaml")
FUNCTION_JSON = "function-json"
DOCUMENTS = (FUNCTION_JSON, *PLATFORMS)


@cache
def catalogue() -> Catalogue:
    return load(shipped_sources()[0])


@cache
def document(kind: str) -> bytes:
    """A document of the function, as it is generated from."""
    (function,) = read_functions([(FUNCTION.read_bytes(), FUNCTION.name)], catalogue()).functions
    if kind == FUNCTION_JSON:
        return to_json(function.function)
    return integrate(PLATFORMS[kind], (function,), DEFAULT_DEPLOYMENT).document


def changed(kind: str, pointer: Pointer, value: Any) -> bytes:
    """A document with another value at a pointer, each on its own line."""
    whole = json.loads(document(kind))
    part = whole
    for key in pointer[:-1]:
        part = part[key]
    part[pointer[-1]] = value
    return json.dumps(whole, indent=1).encode()


def strings(value: Any, at: Pointer = ()) -> Iterator[tuple[Pointer, str]]:
    """Every string of a document with its pointer."""
    if isinstance(value, str):
        yield at, value
    elif isinstance(value, Mapping):
        for key, item in value.items():
            yield from strings(item, (*at, key))
    elif isinstance(value, Sequence):
        for index, item in enumerate(value):
            yield from strings(item, (*at, index))


def one_of_each(kind: str) -> dict[tuple[str, ...], tuple[Pointer, str]]:
    """A pointer and a string for each field of a document: indexes do not make another one."""
    found: dict[tuple[str, ...], tuple[Pointer, str]] = {}
    for at, text in strings(json.loads(document(kind))):
        found.setdefault(tuple("*" if isinstance(part, int) else part for part in at), (at, text))
    return found
