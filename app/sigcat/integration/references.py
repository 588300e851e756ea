"""Names that places of a document refer to, by a table: `Components/*/Events/*/Runnable` is one of `Components/*/Runnables/*/Name`."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.integration.problem import Problem
from sigcat.names import did_you_mean


class Reference(NamedTuple):
    """A place that has the name of something; what both paths begin with is one and the same."""

    at: str
    what: str
    known: tuple[str, ...]
    """Places of the names that it may have."""


def unknown(at: Pointer, what: str, given: str, known: Iterable[str] = ()) -> Problem:
    """A reference to nothing."""
    fix = did_you_mean(given, known) or "Correct the name, or add it."
    return Problem(at, f"{given[:80]!r} must be a known {what}, and is not.", fix)


def unknown_names(model: BaseModel, references: Iterable[Reference]) -> Iterator[Problem]:
    """A problem for each reference to nothing."""
    for each in references:
        shared = _shared(each.at, *each.known)
        known: dict[Pointer, list[str]] = {}
        for path in each.known:
            for at, name in places(model, path):
                known.setdefault(at[:shared], []).append(name)
        for at, name in places(model, each.at):
            if name not in known.get(at[:shared], ()):
                yield unknown(at, each.what, name, known.get(at[:shared], ()))


def places(model: BaseModel, path: str, at: Pointer = ()) -> Iterator[tuple[Pointer, Any]]:
    """Every value at a path below a part of a document, where `*` is any index, with its pointer; none that is absent."""
    return _below(model, tuple(path.split("/")), at)


def _below(part: Any, path: tuple[str, ...], at: Pointer) -> Iterator[tuple[Pointer, Any]]:
    if not path:
        yield at, part
        return
    step, rest = path[0], path[1:]
    inner = enumerate(part) if step == "*" else ((step, getattr(part, _fields(part.__class__)[step])),)
    for key, value in inner:
        if value is not None:
            yield from _below(value, rest, (*at, key))


@cache
def _fields(model: type[BaseModel]) -> Mapping[str, str]:
    """Names of fields, by their names on the wire."""
    return {str(field.alias): name for name, field in model.model_fields.items()}


def _shared(*paths: str) -> int:
    """Number of steps that all paths begin with."""
    steps = zip(*(path.split("/") for path in paths), strict=False)
    return next((number for number, each in enumerate(steps) if len(set(each)) > 1), 0)
