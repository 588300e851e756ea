"""Shapes of an OpenAPI document that generated clients have a type for, made of those that FastAPI and pydantic write."""

from collections.abc import Iterable, Mapping
from typing import Any

Schema = dict[str, Any]
_NULL = {"type": "null"}
_LISTS = ("anyOf", "oneOf", "allOf")


def answered(schema: Schema) -> Schema:
    """A schema of an answer: fields may be added, so clients must not refuse unknown fields."""
    plain: Schema = _simple(schema)
    if plain.get("additionalProperties") is False:
        plain.pop("additionalProperties")
    for field in plain.get("properties", {}).values():
        field.pop("default", None)
    return plain


def written(schema: Schema) -> Schema:
    """A schema of a wire format whose writer leaves out what has no value: only what has to be there may be null."""
    plain = answered(schema)
    required = plain.get("required", ())
    fields = plain.get("properties", {})
    return {
        **plain,
        "properties": {name: field if name in required else not_null(field) for name, field in fields.items()},
    }


def parameter(described: Schema) -> Schema:
    """A parameter: one that is not given is not there, since null cannot be written into an address."""
    schema = not_null(_simple(described.get("schema", {})))
    if schema.get("default", "") is None:
        schema.pop("default")
    return {**described, "schema": schema}


def in_order(parameters: Iterable[Schema], path: str) -> list[Schema]:
    """Parameters as every operation has them: those of the address from left to right, the catalogue, then the rest."""
    return sorted(parameters, key=lambda each: _place(each, path))


def not_null(schema: Schema) -> Schema:
    """A schema without null as one of its alternatives."""
    kinds = [each for each in schema.get("anyOf", ()) if each != _NULL]
    if len(kinds) != 1:
        return schema
    return {**kinds[0], **{key: value for key, value in schema.items() if key != "anyOf"}}


def _place(parameter: Mapping[str, Any], path: str) -> int:
    if parameter["in"] == "path":
        return path.index(f"{{{parameter['name']}}}") - len(path)
    return 0 if parameter["name"] == "catalogue" else 1


def _simple(schema: Any) -> Any:
    """A schema without titles: pydantic makes them of the names of fields, and generators make names of them again."""
    if not isinstance(schema, dict):
        return schema
    plain = {key: value for key, value in schema.items() if key != "title"}
    for key in ("items", "additionalProperties"):
        if key in plain:
            plain[key] = _simple(plain[key])
    for key in _LISTS:
        if key in plain:
            plain[key] = [_simple(each) for each in plain[key]]
    if "properties" in plain:
        plain["properties"] = {name: _simple(field) for name, field in plain["properties"].items()}
    return plain
