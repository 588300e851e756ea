"""The reference of the API as pages: a chapter for each group of operations, its schemas, and its kinds of problems."""

import json
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from fastapi import APIRouter, Request
from fastapi.responses import Response

from sigcat.api.answers.problems import KINDS
from sigcat.api.requests.thread_turns import InThread
from sigcat.errors import NotFound
from sigcat.names import nearest
from sigcat.web.rendering import page
from sigcat.web.visits import mounted_below

router = APIRouter(route_class=InThread)
SCHEMAS = "schemas"
"""The chapter of the schemas."""
ADDRESS = "$SIGCAT"
"""Address of the service in examples: which one a client used is not repeated to it."""


class Parameter(NamedTuple):
    """A parameter of an operation."""

    name: str
    location: str
    type: str
    is_required: bool
    description: str
    example: str


class Operation(NamedTuple):
    """An operation, with its references resolved to names of schemas."""

    id: str
    group: str
    method: str
    path: str
    description: str
    parameters: tuple[Parameter, ...]
    body: Mapping[str, Any] | None
    responses: tuple[tuple[str, str, str], ...]
    """(status, description, name of the schema)"""
    example: str

    @property
    def answers(self) -> tuple[tuple[str, str, str], ...]:
        """Responses of the operation that succeeds; the reference lists the others once."""
        return tuple(each for each in self.responses if each[0].startswith("2"))


class Group(NamedTuple):
    """Operations of one tag."""

    name: str
    description: str
    operations: tuple[Operation, ...]


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
    """The groups of the API with their operations, and the answers that all have in common."""
    document = request.app.openapi()
    found = groups(document, _base(request))
    return page(
        request,
        "docs.html",
        document=document,
        groups=found,
        chapter="",
        failures=failures(found),
        entries=(),
        names=(),
    )


@router.get("/docs/api/{chapter}")
def show_group(request: Request, chapter: str) -> Response:
    """The operations of a group, or the schemas."""
    document = request.app.openapi()
    found, entries = groups(document, _base(request)), schemas(document)
    known = (*(each.name for each in found), SCHEMAS)
    if chapter not in known:
        raise NotFound(f"Unknown chapter {chapter[:100]!r} of the API.", nearest(chapter[:100], known))
    return page(
        request,
        "docs.html",
        document=document,
        groups=found,
        chapter=chapter,
        failures={},
        entries=entries if chapter == SCHEMAS else (),
        names={entry.name for entry in entries},
    )


def _base(request: Request) -> str:
    return ADDRESS + mounted_below(request).rstrip("/")


def groups(document: Mapping[str, Any], base: str) -> list[Group]:
    """The operations of an OpenAPI document by their tags."""
    made = operations(document, base)
    return [
        Group(tag["name"], tag["description"], tuple(each for each in made if each.group == tag["name"]))
        for tag in document["tags"]
    ]


def failures(found: Iterable[Group]) -> dict[str, tuple[str, ...]]:
    """The meanings of every other answer of the operations, by status."""
    answers = {
        (status, description)
        for group in found
        for operation in group.operations
        for status, description, _ in operation.responses
        if not status.startswith("2")
    }
    return {status: tuple(text for code, text in sorted(answers) if code == status) for status, _ in sorted(answers)}


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
            p["name"],
            p["in"],
            type_name(p.get("schema", {})),
            p.get("required", False),
            p.get("description", ""),
            _parameter_example(p),
        )
        for p in entry.get("parameters", [])
    )
    responses = tuple(
        (status, response.get("description", ""), _schema_of(response))
        for status, response in entry.get("responses", {}).items()
    )
    body = entry.get("requestBody")
    return Operation(
        entry.get("operationId", ""), next(iter(entry.get("tags", ())), ""), method.upper(), path, entry.get("description", ""), parameters, body, responses,
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


def _parameter_example(parameter: Mapping[str, Any]) -> str:
    """The first example of a parameter, if it has one."""
    examples = parameter.get("examples") or parameter.get("schema", {}).get("examples") or []
    return str(examples[0]) if examples else ""


def _example(method: str, path: str, entry: Mapping[str, Any], base: str) -> str:
    """A call that works unchanged, where the parameters of the path have examples."""
    for parameter in entry.get("parameters", []):
        example = _parameter_example(parameter)
        if parameter["in"] == "path" and example:
            path = path.replace("{" + parameter["name"] + "}", example)
    if method == "get":
        return f"curl {base}{path}"
    return f"curl --data-binary @FILE {base}{path}"
