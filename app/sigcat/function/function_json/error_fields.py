"""Fields that name an error which the core sets. A model marks them; checks, pages and adapters find them by their marks."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Annotated, NamedTuple

from pydantic import BaseModel

from sigcat.function.document.field_types import Name


@dataclass(frozen=True)
class SetsError:
    """Marks such a field."""

    cause: str = ""
    """The cause of the error, in the words of pages; empty if other fields name it."""
    is_of_consumer: bool = False
    """Whether only who consumes the data can find it."""


SetErrorName = Annotated[Name | None, SetsError()]


class SetError(NamedTuple):
    """An error that a field names."""

    field: str
    key: str
    """The field in Function JSON."""
    mark: SetsError
    error: str


@cache
def error_fields(*models: type[BaseModel]) -> Mapping[str, SetsError]:
    """Return the marks of the fields of models, in their order."""
    fields = [field for model in models for field in model.model_fields.items()]
    return {name: mark for name, info in fields for mark in info.metadata if isinstance(mark, SetsError)}


def errors_set_by(item: BaseModel) -> Iterator[SetError]:
    """Yield the errors that an interface names."""
    kind = type(item)
    for field, mark in error_fields(kind).items():
        if error := getattr(item, field):
            yield SetError(field, str(kind.model_fields[field].alias), mark, error)
