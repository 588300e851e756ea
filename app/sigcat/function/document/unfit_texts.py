"""Strings of a document that the types of their fields refuse."""

from collections.abc import Collection, Iterator
from functools import cache
from typing import Annotated, Any, NamedTuple, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import expression_of
from sigcat.function.document.field_types import C_EXPRESSION, Grammar
from sigcat.function.document.yaml_words import in_yaml
from sigcat.names import did_you_mean


class Unfit(NamedTuple):
    """A string that its type refuses."""

    pointer: Pointer
    message: str
    fix: str
    grammar: Grammar


class StringField(NamedTuple):
    """A field, and the types of the strings in it and of the keys of its mappings."""

    name: str
    alias: str
    values: Grammar | None
    keys: Grammar | None


def unfit_texts(model: BaseModel, accessors: Collection[str] = (), pointer: Pointer = ()) -> Iterator[Unfit]:
    """Every string of a model, and of all models in it, that its type refuses.

    `accessors` are the functions that expressions may call.
    """
    for field in string_fields(type(model)):
        yield from _in_value(getattr(model, field.name), field, accessors, (*pointer, field.alias))


@cache
def string_fields(model: type[BaseModel]) -> tuple[StringField, ...]:
    """The fields of a model with the types of their strings."""
    return tuple(
        StringField(
            name, info.alias or name, _grammar(annotation_of(info)), _grammar(annotation_of(info), of_keys=True)
        )
        for name, info in model.model_fields.items()
    )


def annotation_of(info: FieldInfo) -> Any:
    """The annotation of a field with its metadata, which pydantic keeps apart."""
    return Annotated[info.annotation, *info.metadata] if info.metadata else info.annotation


def _grammar(annotation: Any, *, of_keys: bool = False) -> Grammar | None:
    """The first grammar in an annotation: of strings, or of the keys of a mapping."""
    parts = get_args(annotation)
    if get_origin(annotation) is dict:
        return _grammar(parts[0] if of_keys else parts[1])
    if of_keys and get_origin(annotation) is None:
        return None
    for part in parts:
        found = part if isinstance(part, Grammar) and not of_keys else _grammar(part, of_keys=of_keys)
        if found is not None:
            return found
    return None


def _in_value(value: Any, field: StringField, accessors: Collection[str], at: Pointer) -> Iterator[Unfit]:
    if isinstance(value, BaseModel):
        yield from unfit_texts(value, accessors, at)
    elif isinstance(value, str):
        yield from _in_string(value, field.values, accessors, at)
    elif isinstance(value, tuple | list):
        for index, item in enumerate(value):
            yield from _in_value(item, field, accessors, (*at, index))
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from _in_string(key, field.keys, (), (*at, key)) if isinstance(key, str) else ()
            yield from _in_value(item, field, accessors, (*at, key))


def _in_string(text: str, grammar: Grammar | None, accessors: Collection[str], at: Pointer) -> Iterator[Unfit]:
    if grammar is None:
        return
    if not grammar.accepts(text):
        yield Unfit(at, f"{_titled(at)} must be {grammar.expected}, not {in_yaml(text)}.", grammar.fix, grammar)
    elif grammar is C_EXPRESSION:
        read = expression_of(text)
        for name in read.calls if read else ():
            if name not in accessors:
                message = f"{_titled(at)} must call an accessor of the code, not {name!r}."
                fix = did_you_mean(name, accessors) or f"List {name!r} under `accessors` of `code`."
                yield Unfit(at, message, fix, grammar)


def _titled(at: Pointer) -> str:
    key = next(part for part in reversed(at) if isinstance(part, str))
    return f"`{key[:60]}`" if isinstance(at[-1], str) else f"An entry of `{key[:60]}`"
