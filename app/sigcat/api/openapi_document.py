"""The OpenAPI document: what FastAPI knows of the routes, and what has to be added."""

from collections.abc import Iterator, Mapping
from copy import deepcopy
from threading import Lock
from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from sigcat.api.answers.negotiation import JSON, YAML
from sigcat.api.answers.problems import KINDS, PROBLEM, header_documentation
from sigcat.api.openapi_shapes import answered, in_order, parameter, written
from sigcat.api.settings import Settings
from sigcat.function.function_json.model import FunctionJson
from sigcat.platforms.table import PLATFORMS

Document = dict[str, Any]

TAGS = {
    "catalogues": "Trees, nodes, search, units.",
    "changes": "What changed between two catalogues, and what an overlay would change.",
    "exports": "A catalogue in other formats.",
    "functions": "From the declaration of a function to Function JSON.",
    "integration": "From Function JSON to a platform.",
    "lint": "Checks of a posted text.",
    "operation": "Health, and what an operator does.",
    "registry": "Published versions, their users, and what vehicle lines run.",
    "rules": "The rules for names and fields.",
}
_EVERYWHERE = (422, 429, 431, 500, 503)
"""Statuses of any operation: an unknown parameter, more than a client's share, too long an address, a failure, a service that stops or is busy."""
_MAKING = Lock()
_WITH_STATE = ("/api/v1/catalogues/{catalogue}", "/api/v1/registry")
_WITHOUT_STATE = tuple(f"/api/v1/registry/{each}" for each in ("capabilities", "key", "model"))
_LATER = ("429", "503")
"""Statuses with `Retry-After`."""
_VERSIONED = ("200", "304", "412")
"""Statuses with `ETag`, of operations about a state of a catalogue or of the registry."""
_HEADERS: Mapping[str, Mapping[str, Any]] = {
    "ETag": header_documentation("The state of the catalogue or of the registry, as a weak tag."),
    "Link": header_documentation(
        'The address of the next page, with `rel="next"` (RFC 8288); absent on the last page.'
    ),
    "Location": {
        "description": "The address without the `/`.",
        "schema": {"type": "string", "format": "uri-reference"},
    },
    "RateLimit": header_documentation(
        "What the client may still have under way, for each quota that the request used "
        "(draft-ietf-httpapi-ratelimit-headers-10)."
    ),
    "RateLimit-Policy": header_documentation(
        "The quotas that the request used: `work`, `exports`, `answers`, `long-answers` and `registry` in concurrent "
        "requests, `bodies` in bytes of bodies."
    ),
    "Retry-After": header_documentation("Seconds to wait.", "integer"),
    "X-Request-Id": header_documentation("What the log calls the request."),
}
_MOVED = {"description": "The address must not end with `/`"}
_UNCHANGED = {"description": "The client has this state already (`If-None-Match`)"}
_PAGED = ("list_nodes", "search_nodes", "list_registry_names", "list_log_entries")
_CLOSED = "Authentication required, if reading is restricted"
_FROM_CATALOGUE = {"catalogue": "$request.path.catalogue"}
LINKS: Mapping[str, Mapping[str, Mapping[str, Any]]] = {
    "list_catalogues": {"get_catalogue": {"parameters": {"catalogue": "$response.body#/catalogues/0/id"}}},
    "get_catalogue": {
        "get_tree": {"parameters": _FROM_CATALOGUE},
        "search_nodes": {"parameters": _FROM_CATALOGUE},
        "diff_catalogues": {"parameters": {**_FROM_CATALOGUE, "to": "$response.body#/id"}},
    },
    "get_tree": {"get_node": {"parameters": {**_FROM_CATALOGUE, "path": "$response.body#/subtrees/0/path"}}},
    "search_nodes": {
        "get_node": {"parameters": {**_FROM_CATALOGUE, "path": "$response.body#/hits/0/path"}},
        "search_nodes": {"parameters": {**_FROM_CATALOGUE, "cursor": "$response.body#/next_cursor"}},
    },
    "get_node": {
        name: {"parameters": {**_FROM_CATALOGUE, "path": "$response.body#/path"}}
        for name in ("get_tree", "get_node_history")
    },
    "list_rules": {"get_rule": {"parameters": {"rule_id": "$response.body#/rules/0/id"}}},
    "build_function_json": {
        "validate_function": {"requestBody": "$response.body"},
        "integrate_functions": {"parameters": {"platform": next(iter(PLATFORMS))}, "requestBody": "$response.body"},
    },
    "integrate_functions": {
        f"generate_{generator.name}": {"requestBody": "$response.body"}
        for platform in PLATFORMS.values()
        for generator in platform.generators
    },
}
"""Operations that continue from the answer of another one, with the part of the answer that they use."""


def openapi_document(app: FastAPI) -> Document:
    """The document, made once, whichever threads ask for it first."""
    with _MAKING:
        if app.openapi_schema is None:
            app.openapi_schema = completed(_documented(app))
    return app.openapi_schema


def _documented(app: FastAPI) -> Document:
    return get_openapi(
        title=app.title,
        version=app.version,
        description=app.description,
        routes=app.routes,
        tags=[{"name": name, "description": text} for name, text in TAGS.items()],
        contact=_contact(app.state.settings),
        license_info={"name": "Apache 2.0", "url": "https://www.apache.org/licenses/LICENSE-2.0"},
        servers=[{"url": "/", "description": "Where the document comes from."}],
    )


def _contact(settings: Settings) -> dict[str, str]:
    """Return the contact for the service, as far as its operator states it."""
    stated = {"name": settings.contact_name, "url": settings.contact_url, "email": settings.contact_email}
    return {name: value for name, value in stated.items() if value}


def completed(document: Document) -> Document:
    """The document with problems in every operation, every form of an answer, and links. Changes its argument."""
    ids = {operation["operationId"] for _, _, operation in operations(document)}
    for path, method, operation in operations(document):
        parameters = in_order(map(parameter, operation.get("parameters", ())), path)
        operation.update({"parameters": parameters} if parameters else {})
        responses = operation["responses"]
        has_versions = method == "get" and path.startswith(_WITH_STATE) and path not in _WITHOUT_STATE
        _add_problems(responses, is_open=not path.startswith("/api/"), has_versions=has_versions)
        for response in responses.values():
            _complete_forms(response)
        _add_headers(operation, is_api=path.startswith("/api/"), has_versions=has_versions)
        links = {name: link for name, link in LINKS.get(operation["operationId"], {}).items() if name in ids}
        if links:
            responses["200"]["links"] = {name: {"operationId": name, **link} for name, link in links.items()}
        operation["responses"] = dict(sorted(responses.items()))
    document["security"] = [{}, {"token": []}]
    document["components"]["headers"] = {name: {**header} for name, header in _HEADERS.items()}
    document["components"]["schemas"] = dict(sorted(_schemas(document["components"]["schemas"]).items()))
    return document


def _schemas(made: Mapping[str, dict[str, Any]]) -> dict[str, Any]:
    """The schemas of answers. Function JSON is as it is written, which FastAPI cannot see: the models write themselves."""
    unused = ("HTTPValidationError", "ValidationError")
    function = FunctionJson.model_json_schema(by_alias=True, ref_template="#/components/schemas/{model}")
    of_functions = {**function.pop("$defs"), "FunctionJson": function}
    return {
        **{name: answered(schema) for name, schema in made.items() if name not in unused},
        **{name: written(schema) for name, schema in of_functions.items()},
    }


def _add_problems(responses: dict[str, Any], *, is_open: bool, has_versions: bool) -> None:
    """Add the problems that any operation may answer with, that of operations with an `ETag`, and 304 and 307."""
    for status in (*_EVERYWHERE, *([412] if has_versions else [])):
        responses.setdefault(str(status), {"description": KINDS[status][1], **deepcopy(PROBLEM)})
    if not is_open:
        responses.setdefault("401", {"description": _CLOSED, **deepcopy(PROBLEM)})
        responses.setdefault("307", {**_MOVED})
    if has_versions:
        responses.setdefault("304", {**_UNCHANGED})


def _add_headers(operation: Mapping[str, Any], *, is_api: bool, has_versions: bool) -> None:
    """The headers of every answer."""
    for status, response in operation["responses"].items():
        names = {
            "ETag": has_versions and status in _VERSIONED,
            "Link": operation["operationId"] in _PAGED and status == "200",
            "Location": status == "307",
            "RateLimit": is_api,
            "RateLimit-Policy": is_api,
            "Retry-After": status in _LATER,
            "X-Request-Id": True,
        }
        refers = {name: {"$ref": f"#/components/headers/{name}"} for name, has in names.items() if has}
        response["headers"] = {**response.get("headers", {}), **refers}


def operations(document: Mapping[str, Any]) -> Iterator[tuple[str, str, dict[str, Any]]]:
    """Every operation with its path and method."""
    for path, item in document["paths"].items():
        for method, operation in item.items():
            if method in ("get", "put", "post", "delete", "patch", "head", "options"):
                yield path, method, operation


def _complete_forms(response: dict[str, Any]) -> None:
    """Problems have their own media type; JSON and YAML of the same data have one schema."""
    content = response.get("content", {})
    schema = content.get(JSON, {}).get("schema", {})
    if schema.get("$ref") in _PROBLEMS:
        response.update(deepcopy(PROBLEM))
    elif YAML in content and JSON in content:
        content[YAML] = {"schema": schema}


_PROBLEMS = ("#/components/schemas/Problem", "#/components/schemas/HTTPValidationError")
