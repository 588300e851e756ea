"""The whole contract, tried by schemathesis: no 5xx, no answer outside the schema, whatever is asked.

SIGCAT_FUZZ is the number of examples for each operation; `make fuzz` takes many, and the requests that it finds are tried again.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, settings
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
    status_code_conformance,
)

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.tokens import create_token
from tests.properties import FUZZ, IS_SEARCH, PROPERTY, found, is_literal
from tests.reference_tools import checked_with
from tests.registry.served import settings_of, signed_registry

TREE = Path(__file__).parent / "tree"
LIBRARY = Library([Source("interfaces", "A small tree", TREE / "tree.vspec", (TREE / "overlay.vspec",))])
FOLDER = TemporaryDirectory()
REGISTRY = signed_registry(Path(FOLDER.name))
with writing(REGISTRY.database) as connection:
    TOKEN = {"Authorization": f"Bearer {create_token(connection, 'contract', ['administer'], '', '')}"}
APP = create_app(LIBRARY, Settings(log="none"), registry=settings_of(REGISTRY))
for schema in APP.openapi()["components"]["schemas"].values():
    if "properties" in schema:  # later versions may have more fields; this one has none that it does not name
        schema.setdefault("additionalProperties", False)
SCHEMA = schemathesis.openapi.from_asgi("/openapi.json", APP)
TRIED = SCHEMA if IS_SEARCH else SCHEMA.exclude(path_regex=r"/export/(?!csv|avro)")
"""Formats of export differ in their options alone: a usual run takes two of them, which is half of all work here."""
CHECKS = [
    schemathesis.checks.not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
]
BOUNDED = settings(max_examples=FUZZ or 8, suppress_health_check=list(HealthCheck))
AGAIN = "tests/api/test_contract.py::test_requests_that_a_search_found"
REQUEST = ("method", "path", "path_parameters", "query", "headers", "cookies", "body", "media_type")
RECORDS: list[Callable[[str, object], None]] = []
"""Adds a property to the report of the current test."""


@pytest.fixture(autouse=True)
def recorded(record_property: Callable[[str, object], None]) -> None:
    """A test of a state machine has no fixtures."""
    RECORDS[:] = [record_property]


@contextmanager
def noted(case: "schemathesis.Case[Any]") -> Iterator[None]:
    """Record the request if a check of its answer fails: the last one is the smallest."""
    try:
        yield
    except BaseException:
        parts = {name: getattr(case, name) for name in REQUEST if is_literal(repr(getattr(case, name)))}
        if IS_SEARCH:
            RECORDS[0](PROPERTY, (AGAIN, repr({"request": parts})))
        raise


@checked_with("schemathesis", "Every answer is within the contract, for any request")
@TRIED.parametrize()
@BOUNDED
def test_every_operation_answers_as_its_schema_says(
    case: "schemathesis.Case[Any]", record_property: Callable[[str, object], None]
) -> None:
    with noted(case):
        case.call_and_validate(checks=CHECKS, headers=TOKEN if "/registry" in case.path else None)
    record_property("checks", 1)


def test_requests_that_a_search_found() -> None:
    """A method that a path does not have must not be a failure of the server."""
    for each in found(AGAIN):
        parts = dict(each["request"])
        operations = SCHEMA[parts.pop("path")]
        is_own = parts["method"].lower() in [*operations]
        operation = operations[parts["method"] if is_own else next(iter(operations))]
        operation.Case(**parts).call_and_validate(checks=CHECKS if is_own else CHECKS[:1])


class Journey(SCHEMA.as_state_machine()):  # type: ignore[misc]
    """Goes from answer to request along the links."""

    def validate_response(self, response: schemathesis.Response, case: "schemathesis.Case[Any]", **_: object) -> None:
        with noted(case):
            case.validate_response(response, checks=CHECKS)


TestJourney = Journey.TestCase
TestJourney.settings = settings(BOUNDED, stateful_step_count=6)
