"""The OpenAPI document, from which clients are generated."""

import json
import subprocess
import sys
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
from pydantic import ValidationError

from scripts.openapi import RELEASED, release
from sigcat.api.application import create_app
from sigcat.api.openapi_changes import breaking_changes
from sigcat.api.openapi_document import operations
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, shipped_sources
from sigcat.platforms.table import PLATFORMS
from tests.api.conftest import Ask, asker
from tests.registry.served import settings_of, signed_registry

ROOT = Path(__file__).parents[2]
FILE = ROOT / "docs" / "reference" / "openapi.json"
DOCUMENT: dict[str, Any] = json.loads(FILE.read_bytes())
API = [(path, method, each) for path, method, each in operations(DOCUMENT) if path.startswith("/api/")]
IDS = [each["operationId"] for _, _, each in API]


@pytest.fixture(scope="module")
def shipped(tmp_path_factory: pytest.TempPathFactory) -> Ask:
    registry = settings_of(signed_registry(tmp_path_factory.mktemp("registry")))
    return asker(create_app(Library(shipped_sources()), registry=registry))


def test_the_document_that_is_checked_in_is_the_one_that_is_served(ask: Ask) -> None:
    assert ask("/openapi.json").json() == DOCUMENT, "run `make generate`"


def test_the_document_says_who_answers_for_the_service_as_its_operator_stated_it() -> None:
    stated = Settings(
        contact_name="Signals", contact_url="https://signals.example/help", contact_email="help@signals.example"
    )
    contact = asker(create_app(Library(shipped_sources()), stated))("/openapi.json").json()["info"]["contact"]
    assert contact == {"name": "Signals", "url": "https://signals.example/help", "email": "help@signals.example"}
    with pytest.raises(ValidationError, match=r"contact_url(?s:.*)contact_email"):
        Settings(contact_url="javascript:x", contact_email="nobody")


def test_the_document_breaks_no_client_of_the_released_one() -> None:
    assert breaking_changes(json.loads(RELEASED.read_bytes()), DOCUMENT) == []


def test_what_breaks_clients_is_not_released(tmp_path: Path) -> None:
    released, document = tmp_path / "released.json", deepcopy(DOCUMENT)
    assert release(document, released) == []
    document["paths"].pop(SEARCH)
    assert release(document, released) == [f"GET {SEARCH}: the operation is gone."]
    assert json.loads(released.read_bytes()) == DOCUMENT


@pytest.mark.parametrize(("path", "method", "operation"), API, ids=IDS)
def test_every_operation_documents_the_headers_of_its_answers(
    path: str, method: str, operation: dict[str, Any]
) -> None:
    headers = {status: set(response["headers"]) for status, response in operation["responses"].items()}
    assert all({"X-Request-Id", "RateLimit", "RateLimit-Policy"} <= names for names in headers.values())
    assert all("Retry-After" in headers[status] for status in ("429", "503"))
    assert "Location" in headers["307"]
    is_versioned = method == "get" and path.startswith(("/api/v1/catalogues/{catalogue}", "/api/v1/registry"))
    is_versioned = is_versioned and path.rpartition("/")[2] not in ("capabilities", "key", "model")
    assert [status for status in headers if "ETag" in headers[status]] == (
        ["200", "304", "412"] if is_versioned else []
    )
    named = {name for names in headers.values() for name in names if name in DOCUMENT["components"]["headers"]}
    assert {"X-Request-Id"} <= named <= DOCUMENT["components"]["headers"].keys()


def test_what_answers_send_is_what_the_document_says(ask: Ask) -> None:
    node = "/api/v1/catalogues/small/nodes/Vehicle.Speed"
    answers = {
        "200": ask(node),
        "304": ask(node, headers={"If-None-Match": "*"}),
        "307": ask(f"{node}/"),
        "412": ask(node, headers={"If-Match": '"another"'}),
    }
    described = DOCUMENT["paths"]["/api/v1/catalogues/{catalogue}/nodes/{path}"]["get"]["responses"]
    for status, answer in answers.items():
        assert str(answer.status_code) == status
        always = described[status]["headers"].keys() - {"RateLimit", "RateLimit-Policy"}
        assert {name.lower() for name in always} <= answer.headers.keys()


def test_operation_ids_read_as_function_names() -> None:
    ids = [operation["operationId"] for _, _, operation in operations(DOCUMENT)]
    assert {"list_catalogues", "get_node", "get_tree", "search_nodes", "list_units"} <= set(ids)
    assert len(ids) == len(set(ids))
    assert all(each.isidentifier() for each in ids)


def test_one_schema_stands_for_each_noun() -> None:
    schemas = DOCUMENT["components"]["schemas"]
    assert len(schemas) > 20
    assert not [name for name in schemas if "__" in name or name.endswith(("-Input", "-Output"))]


@pytest.mark.parametrize(("path", "method", "operation"), API, ids=IDS)
def test_every_operation_says_what_its_errors_are(path: str, method: str, operation: dict[str, Any]) -> None:
    errors = {status: each for status, each in operation["responses"].items() if status >= "4"}
    assert {"401", "500"} <= errors.keys()
    for response in errors.values():
        assert response["description"]
        assert response["content"]


def _examples(parameter: dict[str, Any]) -> Iterator[Any]:
    yield from parameter["schema"].get("examples", parameter.get("examples", []))


def _body(operation: dict[str, Any]) -> bytes | None:
    contents = operation.get("requestBody", {}).get("content", {}).values()
    return next((content["example"].encode() for content in contents if "example" in content), None)


IN_THE_ROUND_TRIP = (
    "reload_catalogue",
    "reload_functions",
    "validate_function",
    "integrate_functions",
    "integrate_functions_archive",
    "generate_arxml",
    "generate_autosar_adaptive",
    "generate_autosar_classic",
    "generate_classic_arxml",
    "generate_fmi",
    "generate_ros2",
    "get_registry_content",
    "publish_versions",
    "check_versions",
    "can_deploy",
    "record_deployment",
    "record_release",
    "end_support",
    "acknowledge_deprecation",
    "approve_version",
    "reject_version",
    "deprecate_version",
    "retire_version",
    "set_compatibility_rule",
)
"""They need a token, or what another operation answers: tests/clients and tests/registry have them."""
UNFIT = ("export_avro", "export_vhal")
"""Exports that the shipped catalogue has nothing for: it has no struct types, and limits that no property of Android takes."""
ALONE = [each for each in API if each[2]["operationId"] not in (*IN_THE_ROUND_TRIP, *UNFIT)]


@pytest.mark.parametrize(("path", "method", "operation"), ALONE, ids=[each["operationId"] for *_, each in ALONE])
def test_every_example_works_and_is_answered_as_the_schema_says(
    shipped: Ask, path: str, method: str, operation: dict[str, Any]
) -> None:
    query = {}
    for parameter in operation.get("parameters", []):
        for example in _examples(parameter):
            if parameter["in"] == "path":
                path = path.replace(f"{{{parameter['name']}}}", str(example))
            else:
                query[parameter["name"]] = example
            break
    if "{platform}" in path:
        path = path.replace("{platform}", next(iter(PLATFORMS)))
    query.pop("unit", None)
    query.pop("datatype", None)
    answer = shipped(path, method.upper(), params=query, content=_body(operation))
    assert answer.status_code == 200, answer.text
    content = operation["responses"]["200"].get("content", {})
    schema = content.get("application/json", {}).get("schema")
    if schema:
        jsonschema_rs.validate({**schema, "components": DOCUMENT["components"]}, answer.json())


def test_linting_does_not_load_the_service() -> None:
    code = "import sys, sigcat.rules, sigcat.catalogue.composing.compose; print('fastapi' in sys.modules, 'sigcat.api' in sys.modules)"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.split() == ["False", "False"]


# -- what breaks clients ------------------------------------------------------------------------------------------

NODE = DOCUMENT["paths"]["/api/v1/catalogues/{catalogue}/nodes/{path}"]
SEARCH = "/api/v1/catalogues/{catalogue}/search"


def _changed(change: Any) -> list[str]:
    new = deepcopy(DOCUMENT)
    change(new)
    return breaking_changes(DOCUMENT, new)


def _schema(document: dict[str, Any], name: str) -> Any:
    return document["components"]["schemas"][name]


def _parameter(document: dict[str, Any], name: str) -> Any:
    return next(each for each in document["paths"][SEARCH]["get"]["parameters"] if each["name"] == name)


def _rename_schema(document: dict[str, Any], old: str, new: str) -> None:
    text = json.dumps(document).replace(f'schemas/{old}"', f'schemas/{new}"')
    document.update(json.loads(text))
    document["components"]["schemas"][new] = document["components"]["schemas"].pop(old)


BREAKING = {
    "an operation is gone": (lambda d: d["paths"].pop(SEARCH), "the operation is gone"),
    "an operation has another id": (lambda d: d["paths"][SEARCH]["get"].update(operationId="find"), "'find'"),
    "a field of an answer is gone": (lambda d: _schema(d, "Node")["properties"].pop("unit"), ": 200 unit is gone"),
    "a field may be absent": (lambda d: _schema(d, "Node")["required"].remove("path"), "path may be absent now"),
    "a field is of another type": (
        lambda d: _schema(d, "SearchPage")["properties"]["total"].update(type="string"), ": 200 total may be string now",
    ),
    "a field may be null": (
        lambda d: _schema(d, "Node")["properties"].update(path={"anyOf": [{"type": "string"}, {"type": "null"}]}),
        "may be null or string now",
    ),
    "an enumeration in an answer grows": (
        lambda d: _schema(d, "Severity")["enum"].append("hint"), "may be hint now",
    ),
    "a parameter is gone": (lambda d: d["paths"][SEARCH]["get"]["parameters"].pop(), "is gone"),
    "a parameter is required": (lambda d: _parameter(d, "q").update(required=True), "'q' is required now"),
    "a parameter takes less": (lambda d: _parameter(d, "q").update(schema={"enum": ["a"]}), "no longer takes"),
    "an answer has another media type": (
        lambda d: d["paths"][SEARCH]["get"]["responses"]["200"]["content"].pop("text/csv"), "no longer text/csv",
    ),
    "a header is gone": (
        lambda d: d["paths"][SEARCH]["get"]["responses"]["200"]["headers"].pop("Link"), "no longer has the header Link",
    ),
    "parameters have another order": (
        lambda d: d["paths"][SEARCH]["get"]["parameters"].reverse(), "the order of the parameters is another one",
    ),
    "a schema has another name": (lambda d: _rename_schema(d, "Trial", "Attempt"), "The schema 'Trial' is gone"),
    "a body has another media type": (
        lambda d: d["paths"]["/api/v1/lint"]["post"]["requestBody"]["content"].clear(), "no longer taken",
    ),
}  # fmt: skip

COMPATIBLE = {
    "nothing": lambda _: None,
    "an operation more": lambda d: d["paths"].update({"/api/v1/more": deepcopy(NODE)}),
    "a field more": lambda d: _schema(d, "Node")["properties"].update(more={"type": "string"}),
    "an optional parameter more": lambda d: d["paths"][SEARCH]["get"]["parameters"].append(
        {"in": "query", "name": "more", "schema": {"type": "string"}}
    ),
    "other words": lambda d: d["paths"][SEARCH]["get"].update(description="Finds nodes."),
    "another major version": lambda d: d.update(
        paths={path.replace("/v1/", "/v2/"): item for path, item in list(d["paths"].items())[3:]}
    ),
}


@pytest.mark.parametrize("case", BREAKING)
def test_what_breaks_clients_is_found(case: str) -> None:
    change, expected = BREAKING[case]
    assert any(expected in found for found in _changed(change)), _changed(change)


@pytest.mark.parametrize("case", COMPATIBLE)
def test_what_breaks_no_client_is_left_alone(case: str) -> None:
    assert _changed(COMPATIBLE[case]) == []
