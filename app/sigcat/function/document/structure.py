"""Structural defects of a document, as the models report them, turned into findings with a place."""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from types import UnionType
from typing import Any, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError

from sigcat.catalogue.model.definition import TYPES
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, pointer_text
from sigcat.names import did_you_mean, nearest

_EXPECTED = {
    "string_type": "a text belongs here",
    "int_type": "a whole number belongs here",
    "integer_type": "a whole number belongs here",
    "number_type": "a finite number belongs here",
    "bool_type": "true or false belongs here",
    "list_type": "a list belongs here",
    "tuple_type": "a list belongs here",
    "dict_type": "a mapping belongs here",
    "model_type": "a mapping belongs here",
    "model_attributes_type": "a mapping belongs here",
    "date_type": "a date such as 2025-09-12 belongs here",
    "string_unicode": "a text of Unicode characters belongs here",
}
_PATTERNS = {
    r"^\d+\.\d+\.\d+$": "three numbers such as 1.0.0 belong here",
    r"^DT_[A-Za-z0-9]+$": "`DT_` with letters and digits belongs here",
}
"""What patterns of the models ask for."""
_KINDS = (
    (frozenset(("FunctionInformation",)), "Integration JSON for AUTOSAR adaptive", "`sigcat generate arxml` takes it."),
    (
        frozenset(("FunctionInfo", "CommunicationList")),
        "Integration JSON for ROS 2",
        "It is made for build tools of ROS 2.",
    ),
    (frozenset(("FunctionInfo",)), "Function JSON", "`sigcat function validate` and `sigcat integrate` take it."),
    (
        frozenset(("function", "components")),
        "a function.yaml",
        "`sigcat function build` and `sigcat integrate` take it.",
    ),
)
"""Keys by which documents of other kinds are known, the more special first; what they are, and what takes them."""
_MOST_DEFECTS = 1_000
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_YAML_WORDS = "YAML reads words such as OFF, ON, YES and NO as true or false: put quotes around a text."


def structural_findings(error: ValidationError, document: Document, model: type[BaseModel]) -> Iterator[Finding]:
    """One finding for each defect; of very many the first, and a last one that says how many more there are.

    A document of another kind is one finding: everything in it would be wrong.
    """
    if other := _of_another_kind(document.value, model):
        title, fix = other
        yield Finding("F003", "error", f"This is {title}, which does not belong here.", document.name, 1, 1, fix=fix)
        return
    defects = error.errors(include_url=False, include_context=True)
    meant = set(_meant(defects, model))
    defects = [defect for defect in defects if not (defect["type"] == "missing" and defect["loc"] in meant)]
    for defect in defects[:_MOST_DEFECTS]:
        pointer = _existing(defect["loc"], document.value)
        yield _finding(defect["type"], defect["loc"], pointer, defect, document, model)
    if len(defects) > _MOST_DEFECTS:
        message = f"{len(defects) - _MOST_DEFECTS:,} more values are wrong. Settle the others first."
        yield Finding("F004", "error", message, document.name)


def _of_another_kind(value: Any, model: type[BaseModel]) -> tuple[str, str] | None:
    """What a document is instead, and what to do with it."""
    if not isinstance(value, dict):
        return None
    known = fields_of(model)
    for signs, title, fix in _KINDS:
        if signs <= value.keys() and not signs <= known.keys():
            return title, fix
    is_node = any(
        isinstance(item, dict) and item.get("type") in TYPES for key, item in value.items() if key not in known
    )
    return ("a vspec file", "`sigcat lint` and `sigcat export` take it.") if is_node else None


def _meant(defects: Sequence[Any], model: type[BaseModel]) -> Iterator[Pointer]:
    """Where misspelled keys were meant to stand: what lacks there is not missing as well."""
    missing = {defect["loc"] for defect in defects if defect["type"] == "missing"}
    for defect in defects[:_MOST_DEFECTS] if missing else ():
        location = defect["loc"]
        if defect["type"] == "extra_forbidden" and location:
            yield from ((*location[:-1], near) for near in nearest(str(location[-1]), _keys_beside(location, model), 1))


def _finding(
    kind: str, location: Pointer, pointer: Pointer, defect: Any, document: Document, model: type[BaseModel]
) -> Finding:
    key = str(location[-1]) if location else ""
    place = document.place(pointer)
    if kind == "missing":
        message = f"{key!r} is missing."
        return Finding("F002", "error", message, document.name, *place, pointer=pointer_text(pointer))
    if kind == "extra_forbidden":
        beside = _keys_beside(location, model)
        fix = did_you_mean(key, beside) or (f"Known here are {', '.join(beside)}." if beside else "")
        message = f"{key!r} is not a key that belongs here."
        place = document.place(pointer, of_key=True)
        return Finding("F003", "error", message, document.name, *place, pointer=pointer_text(pointer), fix=fix)
    if key == "[key]":
        message = f"{_shown(defect['input'])} is no name that belongs here."
        fix = "Names are letters and digits, a letter first; a path has points between them."
        if _WORD.fullmatch(str(defect["input"])):  # a good name, where a path is asked for
            fix = f"Write a path, with a branch above the name: 'Branch.{defect['input']}', for example."
        return Finding("F004", "error", message, document.name, *place, pointer=pointer_text(pointer), fix=fix)
    value = defect["input"]
    expected = _EXPECTED.get(kind) or _worded(defect)
    fix = _unquoted(value) if kind == "string_type" else ""
    message = f"{_shown(value)} is no value for {_named(pointer)}: {expected}."
    return Finding("F004", "error", message, document.name, *place, pointer=pointer_text(pointer), fix=fix)


def _unquoted(value: Any) -> str:
    """What to do about a value that was meant as a text."""
    if isinstance(value, bool):
        return _YAML_WORDS
    return "It is read as a number: put quotes around a text." if isinstance(value, int | float) else ""


def _worded(defect: Any) -> str:
    """What pydantic says, as the rest of a sentence: `Input should be 'A' or 'B'` → `it has to be 'A' or 'B'`."""
    message: str = defect["msg"].removesuffix(".")
    pattern = (defect.get("ctx") or {}).get("pattern")
    if pattern in _PATTERNS:
        return _PATTERNS[pattern]
    for prefix in ("Input should be ", "String should ", "List should ", "Tuple should "):
        if message.startswith(prefix):
            return ("it has to be " if prefix.startswith("Input") else "it has to ") + message.removeprefix(prefix)
    return message[:1].lower() + message[1:]


def _existing(location: Pointer, value: Any) -> Pointer:
    """The part of a location that exists in the document: for what is missing, the mapping that lacks it."""
    pointer: list[str | int] = []
    for part in location:
        is_here = part in value if isinstance(value, dict) else _is_index(part, value)
        if not is_here:
            break
        value = value[part]
        pointer.append(part)
    return tuple(pointer)


def _is_index(part: str | int, value: Any) -> bool:
    return isinstance(value, list) and isinstance(part, int) and part < len(value)


def _keys_beside(location: Pointer, model: type[BaseModel]) -> list[str]:
    """Keys that the mapping at a location may have."""
    fields = model_at(model, location[:-1])
    return list(fields_of(fields)) if fields else []


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
    """What models the values of the fields have, in lists or by themselves."""
    return {name: _model_in(annotation) for name, annotation in fields_of(model).items()}


def _values_of_mapping(annotation: Any) -> Any:
    """What stands under the keys of a mapping whose keys the author chooses; None for everything else."""
    if get_origin(annotation) is dict:
        return get_args(annotation)[1]
    parts = get_args(annotation) if get_origin(annotation) in (Union, UnionType) else ()
    return next((get_args(part)[1] for part in parts if get_origin(part) is dict), None)


def _model_in(annotation: Any) -> type[BaseModel] | None:
    """The model that an annotation such as `list[Item] | None` is about."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation
    return next((found for part in getattr(annotation, "__args__", ()) if (found := _model_in(part))), None)


def _named(pointer: Pointer) -> str:
    names = [part for part in pointer if isinstance(part, str)]
    if not names:
        return "the document"
    return f"`{names[-1]}`" if isinstance(pointer[-1], str) else f"an entry of `{names[-1]}`"


def _shown(value: Any) -> str:
    if isinstance(value, dict | list):
        return "A mapping" if isinstance(value, dict) else "A list"
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
