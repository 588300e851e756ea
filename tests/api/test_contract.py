"""The whole contract, tried by schemathesis: no 5xx, no answer outside the schema, whatever is asked.

SIGCAT_FUZZ is the number of examples for each operation; `make fuzz` takes many, and the requests that it finds are tried again.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
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
from tests.judges import judged_by
from tests.properties import FUZZ, IS_SEARCH, PROPERTY, found, is_literal

TREE = Path(__file__).parent / "tree"
LIBRARY = Library([Source("interfaces", "A small tree", TREE / "tree.vspec", (TREE / "overlay.vspec",))])
APP = create_app(LIBRARY, Settings(log="none"))
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
REFUSED: list[str] = []
"""Requests whose answers failed a check in the current test."""


@pytest.fixture(autouse=True)
def written_down(record_property: Callable[[str, object], None]) -> Iterator[None]:
    """The report of a failed search has the last request that failed, which is the smallest."""
    REFUSED.clear()
    yield
    if IS_SEARCH and REFUSED:
        record_property(PROPERTY, (AGAIN, REFUSED[-1]))


@contextmanager
def noted(case: "schemathesis.Case[Any]") -> Iterator[None]:
    """Remember the request if a check of its answer fails."""
    try:
        yield
    except Exception:
        parts = {name: getattr(case, name) for name in REQUEST}
        REFUSED.append(repr({"request": {name: value for name, value in parts.items() if is_literal(repr(value))}}))
        raise


@judged_by("schemathesis", "No answer outside the contract, whatever is asked")
@TRIED.parametrize()
@BOUNDED
def test_every_operation_answers_as_its_schema_says(
    case: "schemathesis.Case[Any]", record_property: Callable[[str, object], None]
) -> None:
    with noted(case):
        case.call_and_validate(checks=CHECKS)
    record_property("judged", 1)


def test_requests_that_a_search_found() -> None:
    for each in found(AGAIN):
        parts = dict(each["request"])
        SCHEMA[parts.pop("path")][parts.pop("method")].Case(**parts).call_and_validate(checks=CHECKS)


class Journey(SCHEMA.as_state_machine()):  # type: ignore[misc]
    """Goes from answer to request along the links."""

    def validate_response(self, response: schemathesis.Response, case: "schemathesis.Case[Any]", **_: object) -> None:
        with noted(case):
            case.validate_response(response, checks=CHECKS)


TestJourney = Journey.TestCase
TestJourney.settings = settings(BOUNDED, stateful_step_count=6)
