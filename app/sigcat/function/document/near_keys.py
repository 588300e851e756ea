"""Keys that no model knows but that are near one it does: probably misspelled."""

from collections.abc import Iterator
from typing import NamedTuple

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.document.structure import fields_of, models_of
from sigcat.names import nearest


class NearKey(NamedTuple):
    """A key, where it stands, and the one that was probably meant."""

    pointer: Pointer
    key: str
    meant: str
    is_meant_there: bool
    """Whether the intended one is there, too, so that nothing is lost."""


def near_keys(value: object, model: type[BaseModel]) -> Iterator[NearKey]:
    """Yield near keys of a document and of all that it holds."""
    waiting: list[tuple[Pointer, object, type[BaseModel]]] = [((), value, model)]
    while waiting:
        pointer, here, form = waiting.pop()
        if isinstance(here, list):
            waiting.extend(((*pointer, i), item, form) for i, item in enumerate(here))
        elif isinstance(here, dict):
            models = models_of(form)
            if not models.keys() >= here.keys():
                yield from _near(pointer, here, form)
            for key, inner in models.items():
                if inner is not None and isinstance(here.get(key), dict | list):
                    waiting.append(((*pointer, key), here[key], inner))


def _near(pointer: Pointer, value: dict[str, object], model: type[BaseModel]) -> Iterator[NearKey]:
    known = fields_of(model)
    for key in value:
        meant = nearest(key, sorted(known, key=lambda name: name in value), limit=1) if key not in known else ()
        if meant:
            yield NearKey((*pointer, key), key, meant[0], meant[0] in value)
