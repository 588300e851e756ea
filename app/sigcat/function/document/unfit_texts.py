"""The strings of a document with the types of their fields, and those that their types refuse."""

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import cache
from typing import Annotated, Any, NamedTuple, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import expression_of
from sigcat.function.document.field_types import C_EXPRESSION, Grammar, Refers
from sigcat.function.document.yaml_words import in_yaml
from sigcat.names import did_you_mean


class Unfit(NamedTuple):
    """A string that its type refuses."""

    pointer: Pointer
    message: str
    fix: str
    grammar: Grammar


class StringField(NamedTuple):
    """A field, the types of the strings in it and of the keys of its mappings, and what the strings name."""

    name: str
    alias: str
    values: Grammar | None
    keys: Grammar | None
    refers: Refers | None


class TypedString(NamedTuple):
    """A string of a document, with its type."""

    pointer: Pointer
    text: str
    grammar: Grammar


def unfit_texts(
    model: BaseModel, accessors: Collection[str] = (), name: Callable[[Pointer], str] | None = None
) -> Iterator[Unfit]:
    """Every string of a model, and of all models in it, that its type refuses.

    `accessors` are the functions that expressions may call; `name` is what messages call the field at a pointer.
    """
    name = name or titled
    for pointer, text, grammar in typed_strings(model):
        if grammar.longest is not None and len(text) > grammar.longest:
            message = f"{name(pointer)} must have at most {grammar.longest:,} characters, not {len(text):,}."
            yield Unfit(pointer, message, "Shorten it.", grammar)
        elif not grammar.accepts(text):
            message = f"{name(pointer)} must be {grammar.expected}, not {in_yaml(text)}."
            yield Unfit(pointer, message, grammar.fix, grammar)
        elif grammar is C_EXPRESSION:
            yield from _unknown_calls(pointer, text, accessors, name(pointer))


def _unknown_calls(pointer: Pointer, text: str, accessors: Collection[str], field: str) -> Iterator[Unfit]:
    read = expression_of(text)
    for name in read.calls if read else ():
        if name not in accessors:
            message = f"{field} must call an accessor of the code, not {name!r}."
            fix = did_you_mean(name, accessors) or f"List {name!r} under `accessors` of `code`."
            yield Unfit(pointer, message, fix, C_EXPRESSION)


def typed_strings(model: BaseModel) -> Sequence[TypedString]:
    """Every string of a model and of all models in it, but for free text."""
    found: list[TypedString] = []
    _add_model(model, (), found)
    return found


def _add_model(model: BaseModel, at: Pointer, found: list[TypedString]) -> None:
    for field in string_fields(type(model)):
        value = getattr(model, field.name)
        if value is not None:
            _add_value(value, field, (*at, field.alias), found)


def _add_value(value: Any, field: StringField, at: Pointer, found: list[TypedString]) -> None:
    if isinstance(value, str):
        if field.values is not None:
            found.append(TypedString(at, value, field.values))
    elif isinstance(value, BaseModel):
        _add_model(value, at, found)
    elif isinstance(value, tuple | list):
        for index, item in enumerate(value):
            _add_value(item, field, (*at, index), found)
    elif isinstance(value, dict):
        for key, item in value.items():
            if field.keys is not None:
                found.append(TypedString((*at, key), key, field.keys))
            _add_value(item, field, (*at, key), found)


@cache
def string_fields(model: type[BaseModel]) -> tuple[StringField, ...]:
    """The fields of a model with the types of their strings."""
    return tuple(
        _string_field(name, info.alias or name, annotation_of(info)) for name, info in model.model_fields.items()
    )


def _string_field(name: str, alias: str, annotation: Any) -> StringField:
    grammars = list(_found(annotation, Grammar))
    keys = list(_found(annotation, Grammar, of_keys=True))
    refers = next(_found(annotation, Refers), None)
    return StringField(name, alias, next(iter(grammars), None), next(iter(keys), None), refers)


def annotation_of(info: FieldInfo) -> Any:
    """The annotation of a field with its metadata, which pydantic keeps apart."""
    return Annotated[info.annotation, *info.metadata] if info.metadata else info.annotation


def _found(annotation: Any, kind: type[Any], *, of_keys: bool = False) -> Iterator[Any]:
    """Parts of an annotation that are of a kind: those of its strings, or of the keys of its mappings."""
    parts = get_args(annotation)
    if get_origin(annotation) is dict:
        yield from _found(parts[0 if of_keys else 1], kind)
        return
    for part in parts:
        if isinstance(part, kind):
            yield from () if of_keys else (part,)
        else:
            yield from _found(part, kind, of_keys=of_keys)


def titled(pointer: Pointer) -> str:
    """Name of a field in messages."""
    key = next(part for part in reversed(pointer) if isinstance(part, str))
    return f"`{key[:60]}`" if isinstance(pointer[-1], str) else f"An entry of `{key[:60]}`"
