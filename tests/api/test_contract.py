"""The whole contract, tried by schemathesis: no 5xx, no answer outside the schema, whatever is asked.

SIGCAT_FUZZ is the number of examples for each operation; `make fuzz` takes many.
"""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

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
from tests.needs import IS_SLOW_RUN

EXAMPLES = int(os.environ.get("SIGCAT_FUZZ", "8"))
TREE = Path(__file__).parent / "tree"
LIBRARY = Library([Source("interfaces", "A small tree", TREE / "tree.vspec", (TREE / "overlay.vspec",))])
APP = create_app(LIBRARY, Settings(log="none"))
for schema in APP.openapi()["components"]["schemas"].values():
    if "properties" in schema:  # later versions may have more fields; this one has none that it does not name
        schema.setdefault("additionalProperties", False)
SCHEMA = schemathesis.openapi.from_asgi("/openapi.json", APP)
TRIED = SCHEMA if IS_SLOW_RUN or "SIGCAT_FUZZ" in os.environ else SCHEMA.exclude(path_regex=r"/export/(?!csv|avro)")
"""Formats of export differ in their options alone: a usual run takes two of them, which is half of all work here."""
CHECKS = [
    schemathesis.checks.not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_headers_conformance,
    response_schema_conformance,
]
BOUNDED = settings(
    max_examples=EXAMPLES,
    derandomize=EXAMPLES < 50,
    suppress_health_check=list(HealthCheck),
    database=None,
)


@judged_by("schemathesis", "No answer outside the contract, whatever is asked")
@TRIED.parametrize()
@BOUNDED
def test_every_operation_answers_as_its_schema_says(
    case: "schemathesis.Case[Any]", record_property: Callable[[str, object], None]
) -> None:
    case.call_and_validate(checks=CHECKS)
    record_property("judged", 1)


class Journey(SCHEMA.as_state_machine()):  # type: ignore[misc]
    """Goes from answer to request along the links."""

    def validate_response(self, response: schemathesis.Response, case: "schemathesis.Case[Any]", **_: object) -> None:
        case.validate_response(response, checks=CHECKS)


TestJourney = Journey.TestCase
TestJourney.settings = settings(BOUNDED, stateful_step_count=6)
