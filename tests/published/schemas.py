"""The JSON schemas that the authors of the method published, restated: which fields there are, of which kind, and which must be there.

A schema is a YAML file beside this one: `definition: {kind: field field? …}`, where `field?` may be left out and `document` is
the whole. A kind is one of the words below, `one of A B`, the name of a definition, `list of KIND/KIND`, or several of them with
` or ` between.
"""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import yaml

_NUMERIC = "float double int32 int64 uint32 uint64 float32 bool int8_t uint8_t int16_t uint16_t"
WORDS: Mapping[str, Mapping[str, Any]] = {
    "text": {"type": "string"},
    "number": {"type": "number"},
    "integer": {"type": "integer"},
    "boolean": {"type": "boolean"},
    "null": {"type": "null"},
    "datatype name": {"type": "string", "pattern": r"^DT_[A-Za-z0-9]+$"},
    "date": {"type": "string", "pattern": r"^\d{2}.\d{2}.\d{4}$"},
    "day": {"type": "string", "pattern": r"^\d{4}-\d{2}-\d{2}$"},
    "numeric type": {"type": "string", "enum": _NUMERIC.split()},
    "version": {"type": "string", "pattern": r"^\d+\.\d+\.\d+$"},
}


class Field(NamedTuple):
    """A field of a definition."""

    kind: str
    is_required: bool


Definitions = Mapping[str, Mapping[str, Field]]


@cache
def definitions(name: str) -> Definitions:
    """The definitions of one of the files: `function_json`, `autosar_adaptive`, `ros2`."""
    content = yaml.safe_load(Path(__file__).with_name(f"{name}.yaml").read_text(encoding="utf-8"))
    inherited = definitions(content.pop("all of")) if "all of" in content else {}
    return {**inherited, **{definition: _fields(kinds) for definition, kinds in content.items()}}


def _fields(kinds: Mapping[str, str]) -> Mapping[str, Field]:
    return {
        name.removesuffix("?"): Field(kind, is_required=not name.endswith("?"))
        for kind, names in kinds.items()
        for name in names.split()
    }


def schema(name: str) -> dict[str, Any]:
    """The same as a JSON schema."""
    made = {definition: _object(fields) for definition, fields in definitions(name).items()}
    return {**made.pop("document"), "$defs": made}


def _object(fields: Mapping[str, Field]) -> dict[str, Any]:
    required = [name for name, field in fields.items() if field.is_required]
    properties = {name: _kind(field.kind) for name, field in fields.items()}
    return {"type": "object", "properties": properties, "required": required}


def _kind(text: str, between: str = " or ") -> Mapping[str, Any]:
    kinds = [_one(each) for each in text.split(between)]
    return kinds[0] if len(kinds) == 1 else {"anyOf": kinds}


def _one(text: str) -> Mapping[str, Any]:
    if text.startswith("list of "):
        return {"type": "array", "items": _kind(text.removeprefix("list of "), "/")}
    if text.startswith("one of "):
        return {"enum": text.removeprefix("one of ").split()}
    return WORDS.get(text) or {"$ref": f"#/$defs/{text}"}


def restated(published: Mapping[str, Any]) -> Definitions:
    """A published JSON schema in these words."""
    found = {"document": published, **published["$defs"]}
    return {
        name: {
            field: Field(_words(kind, published), field in definition.get("required", ()))
            for field, kind in definition["properties"].items()
        }
        for name, definition in found.items()
        if "properties" in definition
    }


def _words(kind: Mapping[str, Any], published: Mapping[str, Any], between: str = " or ") -> str:
    if "anyOf" in kind:
        return between.join(_words(each, published) for each in kind["anyOf"])
    if "$ref" in kind:
        name = kind["$ref"].rpartition("/")[2]
        definition = published["$defs"][name]
        return name if "properties" in definition else _words(definition, published)
    if kind["type"] == "array":
        return f"list of {_words(kind['items'], published, '/')}"
    return _simple(kind)


def _simple(kind: Mapping[str, Any]) -> str:
    pattern = kind.get("pattern", "")
    if pattern.startswith("^("):
        return f"one of {' '.join(pattern[2:-2].split('|'))}"
    wanted = {key: kind[key] for key in ("type", "pattern", "enum") if key in kind}
    return next(word for word, meaning in WORDS.items() if meaning == wanted)
