"""A part of a function as it leaves its resolver: what it became, where it was declared, and what is missing in it."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from typing import Any, Generic, NamedTuple, TypeVar

from sigcat.function.declaration.form import DeclarationModel, key_of
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.resolving.context import Context
from sigcat.names import camel_case

T = TypeVar("T")
Item = TypeVar("Item")

_ON_THE_WIRE = {
    "function": "FunctionName", "responsible": "FunctionResponsible", "author": "SchemaAuthor",
    "init": "InitValue", "unit": "Units", "path": "VssPath", "provider": "ExternalProvider",
    "kind": "Interfacetype", "runnables": "RunnablesList", "success": "SuccessValue", "before": "PreProcessing",
    "after": "PostProcessing", "unknown": "UnknownAction", "events": "EventList",
    "definitions": "Macros",
}  # fmt: skip
"""Fields of Function JSON that are not simply those of the declaration in CamelCase."""


class Part(NamedTuple, Generic[T]):
    """One part. `value` is None if it could not be resolved."""

    value: T | None
    origin: Origin
    missing: tuple[Subject, ...] = ()
    """Parts that the function lacks because this one could not be resolved: this part, and those within it."""


Resolver = Callable[[Item, Pointer, Context], Part[T]]


def each(items: Iterable[Item], at: Pointer, context: Context, resolver: Resolver[Item, T]) -> list[Part[T]]:
    """Every item of a list, resolved."""
    return [resolver(item, (*at, index), context) for index, item in enumerate(items)]


def values_of(parts: Iterable[Part[T]]) -> tuple[T, ...]:
    """Return the values of parts that could be resolved."""
    return tuple(part.value for part in parts if part.value is not None)


def origin_of(parts: Iterable[Part[T]], at: Pointer) -> Origin:
    """Origin of a list in Function JSON; what could not be resolved is not in it."""
    return Origin(at, dict(enumerate(part.origin for part in parts if part.value is not None)))


def missing_in(parts: Iterable[Part[T]]) -> tuple[Subject, ...]:
    """Return all that is missing in any of the parts."""
    return tuple(subject for part in parts for subject in part.missing)


def written(item: DeclarationModel, at: Pointer) -> Mapping[str | int, Origin]:
    """Origins of the fields that the author wrote, by their names in Function JSON."""
    names = _names(type(item))
    given = ((*names[field], getattr(item, field)) for field in item.model_fields_set)
    return {wire: _written((*at, key), value) for key, wire, value in given}


def listed(items: Sequence[DeclarationModel], at: Pointer) -> Origin:
    """Origin of a list of parts that need nothing of the catalogue, each with its fields."""
    return Origin(at, {i: Origin((*at, i), written(item, (*at, i))) for i, item in enumerate(items)})


def _written(at: Pointer, value: Any) -> Origin:
    """A field with its parts, but for lists of parts with their own resolvers. A mapping is a list in Function JSON."""
    if not isinstance(value, DeclarationModel | list | dict):
        return Origin(at)
    if isinstance(value, DeclarationModel):
        return Origin(at, written(value, at))
    keys = range(len(value)) if isinstance(value, list) else value
    return Origin(at, {index: Origin((*at, key)) for index, key in enumerate(keys)})


@cache
def _names(model: type[DeclarationModel]) -> Mapping[str, tuple[str, str]]:
    """Keys of a declaration and fields of Function JSON, by the fields of a model."""
    return {
        field: (info.alias or key_of(field), _ON_THE_WIRE.get(field, camel_case(field)))
        for field, info in model.model_fields.items()
    }
