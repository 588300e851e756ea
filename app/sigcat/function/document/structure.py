"""Structural errors of a document, as the models report them, turned into findings with a position."""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from types import UnionType
from typing import Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import PydanticCustomError

from sigcat import codes
from sigcat.asil import level_of
from sigcat.catalogue.model.definition import TYPES
from sigcat.catalogue.reading.yaml_scalars import number_advice
from sigcat.file_kind import DOCUMENT_KINDS, document_kind
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, has_part
from sigcat.function.document.field_types import C_VARIABLE_TYPE
from sigcat.function.document.yaml_words import in_yaml
from sigcat.limits import FUNCTION_PROBLEMS
from sigcat.names import did_you_mean, either, nearest

_EXPECTED = {
    "string_type": "a text",
    "int_type": "a whole number",
    "integer_type": "a whole number",
    "number_type": "a finite number",
    "bool_type": "true or false",
    "list_type": "a list",
    "tuple_type": "a list",
    "dict_type": "a mapping",
    "model_type": "a mapping",
    "model_attributes_type": "a mapping",
    "invalid_key": "a text",
    "date_type": "a date such as 2025-09-12",
    "string_unicode": "a text of Unicode characters",
}
"""Expected value, by the kind of the error that pydantic reports."""
_NUMBERS = ("number_type", "int_type", "integer_type")
_PATTERNS = {
    r"^\d+\.\d+\.\d+$": "three numbers such as 1.0.0",
    r"^DT_[A-Za-z0-9]+$": "`DT_` with letters and digits",
    r"^[A-Za-z][A-Za-z0-9_]{0,127}(::[A-Za-z][A-Za-z0-9_]{0,127})*$": "C++ namespaces such as eco::control",
    r"^[A-Za-z][A-Za-z0-9_]{0,127}$": "letters, digits and underscores, a letter first, 128 at most",
    r"^[A-Za-z_][A-Za-z0-9_]{0,127}$": "letters, digits and underscores, no digit first, 128 at most",
    C_VARIABLE_TYPE: "a type of C such as boolean_T or volatile unsigned char",
}
"""Meaning of the patterns of the models."""
_BOUNDS = {
    "greater_than_equal": ("ge", "{} or more"),
    "greater_than": ("gt", "more than {}"),
    "less_than_equal": ("le", "{} or less"),
    "less_than": ("lt", "less than {}"),
}
_QUOTED = re.compile(r"'([^']*)'")
_UNFIT = "unfit"
_BAD_KEY = "invalid_key"
"""Error of a key of a model that is not a text."""
_OF_KIND = ("union_tag_invalid", "union_tag_not_found")
"""Errors of a mapping that is one of several kinds, which one of its keys names."""
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_READ_AS_TRUTH = frozenset(("on", "off", "yes", "no", "true", "false"))
_YAML_WORDS = "Put quotes around it: YAML reads words such as OFF, ON, YES and NO as true or false."


def unfit(message: str, *keys: str) -> PydanticCustomError:
    """An error of a model whose keys contradict each other; its place is the first key in the file."""
    return PydanticCustomError(_UNFIT, "{message}", {"message": message, "keys": keys})


def structural_findings(invalid: ValidationError, document: Document, model: type[BaseModel]) -> Iterator[Finding]:
    """One finding for each error; of very many the first, and a last one that says how many more there are.

    A document of another kind is one finding: everything in it would be wrong.
    """
    if other := _of_another_kind(document.value, model):
        title, fix = other
        message = f"The document must be {_title(model)}, not {title}."
        yield codes.FIELD_UNKNOWN.finding(message, document.name, 1, 1, fix=fix)
        return
    errors = invalid.errors(include_url=False, include_context=True)
    meant = set(_meant(errors, model))
    errors = [error for error in errors if not (error["type"] == "missing" and error["loc"] in meant)]
    for error in errors[:FUNCTION_PROBLEMS]:
        pointer = _existing(error["loc"], document.value)
        yield (
            _bad_kind(pointer, error, document)
            if error["type"] in _OF_KIND
            else _finding(error["type"], error["loc"], pointer, error, document, model)
        )
    if len(errors) > FUNCTION_PROBLEMS:
        message = f"{len(errors) - FUNCTION_PROBLEMS:,} more values are wrong."
        yield codes.VALUE_UNFIT.finding(message, document.name, fix="Correct the others first.")


def _of_another_kind(value: Any, model: type[BaseModel]) -> tuple[str, str] | None:
    """The kind of document that it is instead, and how to use it."""
    if not isinstance(value, dict):
        return None
    known = fields_of(model)
    for kind in DOCUMENT_KINDS:
        if kind.keys <= value.keys() and not kind.keys <= known.keys():
            return kind.title, kind.use
    is_node = any(
        isinstance(item, dict) and item.get("type") in TYPES for key, item in value.items() if key not in known
    )
    return ("a vspec file", "Run `sigcat lint` or `sigcat export` on it.") if is_node else None


def _title(model: type[BaseModel]) -> str:
    """Title of the documents of a model."""
    kind = document_kind(fields_of(model))
    return kind.title if kind else f"a {model.__name__.lower()}"


def _meant(errors: Sequence[Any], model: type[BaseModel]) -> Iterator[Pointer]:
    """Places where misspelled keys belong: these keys are not missing as well."""
    missing = {error["loc"] for error in errors if error["type"] == "missing"}
    for error in errors[:FUNCTION_PROBLEMS] if missing else ():
        location = error["loc"]
        if error["type"] == "extra_forbidden" and location:
            yield from ((*location[:-1], near) for near in nearest(str(location[-1]), _keys_beside(location, model), 1))


def _finding(
    kind: str, location: Pointer, pointer: Pointer, error: Any, document: Document, model: type[BaseModel]
) -> Finding:
    key = str(location[-1]) if location else ""
    if kind == "missing":
        words = _words_at(location, model)
        fix = f"Write {key}: {either(words)}." if words else ""
        return document.finding(codes.FIELD_MISSING, pointer, f"{key!r} is missing.", fix)
    if kind == "extra_forbidden":
        beside = _keys_beside(location, model)
        fix = did_you_mean(key, beside) or (f"Use one of {', '.join(beside)}." if beside else "")
        return document.finding(codes.FIELD_UNKNOWN, pointer, f"Unknown key {key!r}.", fix, of_key=True)
    if kind == _UNFIT:
        return document.finding(codes.VALUE_UNFIT, _first_there(pointer, error, document), error["msg"])
    if key == "[key]" and isinstance(error["input"], str):
        return _bad_name(str(error["input"]), pointer, document)
    if kind == "too_short" and isinstance(error["input"], list):
        least, count = error["ctx"]["min_length"], len(error["input"])
        items = f"{least} item" if least == 1 else f"{least} items"
        message = f"{_place_in_words(pointer)} must have at least {items}, and has {count}."
        return document.finding(codes.VALUE_UNFIT, pointer, message)
    named = "A key" if key == "[key]" or kind == _BAD_KEY else _place_in_words(pointer)
    message = f"{named} must {_wanted(kind, error)}, not {_shown(error['input'])}."
    return document.finding(codes.VALUE_UNFIT, pointer, message, _advice(kind, error))


def _first_there(pointer: Pointer, error: Any, document: Document) -> Pointer:
    """The first of the keys of an error that its mapping has; the mapping, if it has none."""
    found = (_existing((*pointer, key), document.value) for key in error["ctx"]["keys"])
    return next((at for at in found if at != pointer), pointer)


def _bad_kind(pointer: Pointer, error: Any, document: Document) -> Finding:
    """A mapping whose kind is missing or unknown."""
    key = error["ctx"]["discriminator"].strip("'")
    if key not in error["input"]:
        return document.finding(codes.FIELD_MISSING, pointer, f"{key!r} is missing.")
    given, kinds = error["input"][key], _QUOTED.findall(error["ctx"].get("expected_tags", ""))
    wanted = either(kinds) if kinds else "a text"
    fix = did_you_mean(given, kinds) if isinstance(given, str) else ""
    message = f"`{key}` must be {wanted}, not {_shown(given)}."
    return document.finding(codes.VALUE_UNFIT, (*pointer, key), message, fix)


def _bad_name(name: str, pointer: Pointer, document: Document) -> Finding:
    """A name that the author chose, where another form is required."""
    if _WORD.fullmatch(name):  # a good name, where a path is asked for
        message, fix = f"{_shown(name)} must be a path.", f"Write a branch above the name, such as 'Branch.{name}'."
    else:
        message = f"A name must be letters, digits and underscores after a letter, not {_shown(name)}."
        fix = "Write a path with points between its names."
    return document.finding(codes.VALUE_UNFIT, pointer, message, fix)


def _advice(kind: str, error: Any) -> str:
    """The fix for a value of a wrong kind."""
    given = error["input"]
    allowed = _QUOTED.findall(error["ctx"]["expected"]) if kind == "literal_error" else []
    if kind in ("string_type", _BAD_KEY) or _is_unquoted_word(given, allowed):
        return _unquoted(given)
    if kind in _NUMBERS and isinstance(given, str):
        return number_advice(given, is_whole=kind != "number_type")
    return _word_meant(given, allowed) if isinstance(given, str) and allowed else ""


def _unquoted(value: Any) -> str:
    """Advice for a value that was meant as a text."""
    if isinstance(value, bool):
        return _YAML_WORDS
    return "Put quotes around it: it is read as a number." if isinstance(value, int | float) else ""


def _is_unquoted_word(given: Any, allowed: Sequence[str]) -> bool:
    """Whether an allowed word was written that YAML reads as a number, or one that it reads as true or false."""
    if isinstance(given, bool):
        return any(word.lower() in _READ_AS_TRUTH for word in allowed)
    return not isinstance(given, str) and str(given) in allowed


def _word_meant(given: str, allowed: Sequence[str]) -> str:
    """Advice for a word that is close to an allowed one: `ASIL B`, `Consumed`."""
    same = [word for word in allowed if word.lower() == given.lower() or word == level_of(given)]
    return f"Write {same[0]}." if same else did_you_mean(given, allowed)


def _wanted(kind: str, error: Any) -> str:
    """Expected value, as the rest of a sentence: `be a text`, `be 'A' or 'B'`, `have at least 1 item`."""
    if kind in _EXPECTED:
        return f"be {_EXPECTED[kind]}"
    context = error.get("ctx") or {}
    if kind in _BOUNDS:
        bound, words = _BOUNDS[kind]
        return f"be {words.format(context[bound])}"
    if context.get("pattern") in _PATTERNS:
        return f"be {_PATTERNS[context['pattern']]}"
    message: str = error["msg"].removesuffix(".")
    subject, should, rest = message.partition(" should ")
    return rest if should else f"be valid ({subject[:1].lower()}{subject[1:]})"


def _existing(location: Pointer, value: Any) -> Pointer:
    """The part of a location that exists in the document: for what is missing, the mapping that lacks it.

    pydantic names the kind of a mapping on the way into one of several kinds; the document does not.
    """
    pointer: list[str | int] = []
    for part in location:
        if has_part(value, part):
            value = value[part]
            pointer.append(part)
        elif not isinstance(value, dict):
            break
    return tuple(pointer)


def _keys_beside(location: Pointer, model: type[BaseModel]) -> list[str]:
    """Keys that the mapping at a location may have."""
    fields = model_at(model, location[:-1])
    return list(fields_of(fields)) if fields else []


def _words_at(location: Pointer, model: type[BaseModel]) -> Sequence[str | int]:
    """Words or numbers of which the field at a location has one; none for a field of another type."""
    holder = model_at(model, location[:-1])
    annotation = fields_of(holder).get(str(location[-1])) if holder else None
    return get_args(annotation) if get_origin(annotation) is Literal else ()


def model_at(model: type[BaseModel], location: Pointer) -> type[BaseModel] | None:
    """The model of the mapping that a location leads to."""
    current: Any = model
    for part in location:
        if isinstance(part, int):
            continue
        values = _values_of_mapping(current)
        if values is None:
            one = _model_in(current)
            current = fields_of(one).get(part) if one is not None else None
        else:
            current = values
    return _model_in(current) if _values_of_mapping(current) is None else None


@cache
def fields_of(model: type[BaseModel]) -> Mapping[str, Any]:
    """Annotations of the fields by their names in documents."""
    return {field.alias or name: field.annotation for name, field in model.model_fields.items()}


@cache
def models_of(model: type[BaseModel]) -> Mapping[str, type[BaseModel] | None]:
    """Return the model of each field's values, in lists or by themselves."""
    return {name: _model_in(annotation) for name, annotation in fields_of(model).items()}


def _values_of_mapping(annotation: Any) -> Any:
    """Return the type of the values of a mapping whose keys the author chooses; None for everything else."""
    if get_origin(annotation) is dict:
        return get_args(annotation)[1]
    parts = get_args(annotation) if get_origin(annotation) in (Union, UnionType) else ()
    return next((get_args(part)[1] for part in parts if get_origin(part) is dict), None)


def _model_in(annotation: Any) -> type[BaseModel] | None:
    """The model that an annotation such as `list[Item] | None` is about."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next((found for part in getattr(annotation, "__args__", ()) if (found := _model_in(part))), None)


def _place_in_words(pointer: Pointer) -> str:
    names = [part for part in pointer if isinstance(part, str)]
    if not names:
        return "The document"
    return f"`{names[-1]}`" if isinstance(pointer[-1], str) else f"An entry of `{names[-1]}`"


def _shown(value: Any) -> str:
    if isinstance(value, dict | list):
        return "a mapping" if isinstance(value, dict) else "a list"
    return in_yaml(value)
