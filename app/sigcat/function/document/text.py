"""Free text of documents: descriptions, names of people and organizations, conditions that people read."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from html import escape
from operator import attrgetter
from typing import Annotated, Any, NoReturn, final

from pydantic import BeforeValidator, GetCoreSchemaHandler, PlainSerializer, ValidatorFunctionWrapHandler
from pydantic_core import CoreSchema
from pydantic_core.core_schema import (
    no_info_wrap_validator_function,
    plain_serializer_function_ser_schema,
    str_schema,
)

from sigcat.function.document.field_types import FREE

_REFUSED = "text of a document is written by a filter of sigcat.function.document.text_filters, which knows the place"


@final
@dataclass(frozen=True, order=True, slots=True, repr=False)
class Text:
    """Any characters. It is not a `str`, so that it reaches a generated file through `sigcat.function.document.text_filters` alone."""

    raw: str

    def __bool__(self) -> bool:
        return bool(self.raw)

    def __repr__(self) -> str:
        return f"<Text of {len(self.raw)} characters>"

    def __str__(self) -> NoReturn:
        raise TypeError(_REFUSED)

    def __format__(self, specification: str) -> NoReturn:
        raise TypeError(_REFUSED)

    def __html__(self) -> str:
        return escape(self.raw)

    @classmethod
    def __get_pydantic_core_schema__(cls, source: type, handler: GetCoreSchemaHandler) -> CoreSchema:
        serialized = plain_serializer_function_ser_schema(attrgetter("raw"), return_schema=str_schema())
        return no_info_wrap_validator_function(_validated, str_schema(), serialization=serialized)


def _with_texts(value: Any) -> Any:
    return _changed(value, lambda each: Text(each) if isinstance(each, str) else each)


def _with_strings(value: Any) -> Any:
    return _changed(value, lambda each: each.raw if isinstance(each, Text) else each)


def _changed(value: Any, change: Callable[[Any], Any]) -> Any:
    """A value whose innermost values are changed."""
    if isinstance(value, dict):
        return {key: _changed(each, change) for key, each in value.items()}
    return [_changed(each, change) for each in value] if isinstance(value, list | tuple) else change(value)


AnyValue = Annotated[Any, FREE, BeforeValidator(_with_texts), PlainSerializer(_with_strings)]
"""A value of any kind, whose strings are texts."""


def optional(text: str | None) -> Text | None:
    """Text, if there is any."""
    return None if text is None else Text(text)


def composed(*parts: Text | str) -> Text:
    """Texts, one after the other."""
    return Text("".join(part.raw if isinstance(part, Text) else part for part in parts))


def json_of(text: Text | None) -> Any:
    """The value that a text has as JSON; None if it is not JSON."""
    try:
        return None if text is None else json.loads(text.raw)
    except (ValueError, RecursionError):
        return None


def sentence(*parts: Text | str | None) -> Text:
    """The parts that are there as one sentence, or nothing."""
    known = "; ".join(part.rstrip(".;") for part in (composed(each or "").raw.strip() for each in parts) if part)
    return Text(known if known.endswith(("!", "?")) or not known else f"{known}.")


def _validated(value: Any, validate: ValidatorFunctionWrapHandler) -> Text:
    return value if isinstance(value, Text) else Text(validate(value))
