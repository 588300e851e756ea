"""The reference of the API as pages: its operations, from the OpenAPI document, and its kinds of problems."""

import json
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from fastapi import APIRouter, Request
from fastapi.responses import Response

from sigcat.api.answers.problems import KINDS
from sigcat.api.requests.thread_turns import InThread
from sigcat.errors import NotFound
from sigcat.web.rendering import page
from sigcat.web.visits import mounted_below

router = APIRouter(route_class=InThread)
ADDRESS = "$SIGCAT"
"""Address of the service in examples: which one a client used is not repeated to it."""


class Parameter(NamedTuple):
    """A parameter of an operation."""

    name: str
    location: str
    type: str
    is_required: bool
    description: str


class Operation(NamedTuple):
    """An operation, with its references resolved to names of schemas."""

    id: str
    method: str
    path: str
    description: str
    parameters: tuple[Parameter, ...]
    body: Mapping[str, Any] | None
    responses: tuple[tuple[str, str, str], ...]
    """(status, description, name of the schema)"""
    example: str


class Field(NamedTuple):
    """A field of a schema."""

    name: str
    type: str
    is_required: bool
    description: str


class SchemaEntry(NamedTuple):
    """A schema with its fields, or, if it has none, with what it allows."""

    name: str
    description: str
    type: str
    fields: tuple[Field, ...]


@router.get("/docs")
def show_reference(request: Request) -> Response:
    """Every operation and schema of the API."""
    document = request.app.openapi()
    base = ADDRESS + mounted_below(request).rstrip("/")
    entries = schemas(document)
    return page(
        request,
        "docs.html",
        document=document,
        operations=operations(document, base),
        schemas=entries,
        schema_names={entry.name for entry in entries},
    )


@router.get("/problems/{kind}")
def show_problem_kind(request: Request, kind: str) -> Response:
    """Return the meaning of a kind of problem: the address in its `type`."""
    known = {name: (status, title) for status, (name, title) in KINDS.items()}
    if kind not in known:
        raise NotFound(f"Unknown kind of problem {kind!r}.", tuple(known))
    status, title = known[kind]
    return page(request, "problem_kind.html", kinds=known, code=status, title=title)


def operations(document: Mapping[str, Any], base: str) -> list[Operation]:
    """The operations of an OpenAPI document, in its order."""
    return [
        _operation(method, path, entry, base)
        for path, methods in document["paths"].items()
        for method, entry in methods.items()
    ]


def schemas(document: Mapping[str, Any]) -> list[SchemaEntry]:
    """The schemas of an OpenAPI document, by name."""
    entries = sorted(document.get("components", {}).get("schemas", {}).items())
    return [
        SchemaEntry(name, str(entry.get("description", "")), type_name(entry), tuple(_fields(entry)))
        for name, entry in entries
    ]


def _operation(method: str, path: str, entry: Mapping[str, Any], base: str) -> Operation:
    parameters = tuple(
        Parameter(
            p["name"], p["in"], type_name(p.get("schema", {})), p.get("required", False), p.get("description", "")
        )
        for p in entry.get("parameters", [])
    )
    responses = tuple(
        (status, response.get("description", ""), _schema_of(response))
        for status, response in entry.get("responses", {}).items()
    )
    body = entry.get("requestBody")
    return Operation(
        entry.get("operationId", ""), method.upper(), path, entry.get("description", ""), parameters, body, responses,
        _example(method, path, entry, base),
    )  # fmt: skip


def _schema_of(response: Mapping[str, Any]) -> str:
    contents = response.get("content", {}).values()
    return next((type_name(content.get("schema", {})) for content in contents), "")


def _fields(entry: Mapping[str, Any]) -> Iterator[Field]:
    required = entry.get("required", [])
    for name, schema in entry.get("properties", {}).items():
        yield Field(name, type_name(schema), name in required, schema.get("description", ""))


def type_name(schema: Mapping[str, Any]) -> str:
    """A schema in a few words: `Finding[]`, `string or null`, `object of integer`."""
    if "$ref" in schema:
        return str(schema["$ref"]).rpartition("/")[2]
    if "anyOf" in schema:
        return " or ".join(type_name(each) for each in schema["anyOf"])
    if "enum" in schema:
        return " | ".join(json.dumps(value) for value in schema["enum"])
    if schema.get("type") == "array":
        return f"{type_name(schema.get('items', {}))}[]"
    if isinstance(schema.get("additionalProperties"), dict) and schema["additionalProperties"]:
        return f"object of {type_name(schema['additionalProperties'])}"
    return str(schema.get("type", "any"))


def _example(method: str, path: str, entry: Mapping[str, Any], base: str) -> str:
    """A call that works unchanged, where the parameters of the path have examples."""
    for parameter in entry.get("parameters", []):
        examples = parameter.get("examples") or parameter.get("schema", {}).get("examples") or []
        if parameter["in"] == "path" and examples:
            path = path.replace("{" + parameter["name"] + "}", str(examples[0]))
    if method == "get":
        return f"curl {base}{path}"
    return f"curl --data-binary @FILE {base}{path}"
