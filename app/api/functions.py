"""Routes that take a function from its declaration to Function JSON."""

from typing import Annotated

from fastapi import APIRouter, Query
from fastapi.responses import Response

from app.api import schemas
from app.api.presenting import lint_report
from app.api.problems import problem_documentation
from app.api.requests import NamedCatalogue, PostedText, text_body
from app.function.build import build_function
from app.function.model import FunctionJson, to_json
from app.function.validate import validate_function_json

router = APIRouter(prefix="/api/v1/functions", tags=["functions"])

_DECLARATION = """\
function: WheelSpeedCalculation
version: 1.0.0
description: Turns the rotation of the four wheels into their speeds over ground.
"""

FileName = Annotated[str, Query(max_length=300, description="What findings call the text.")]


@router.post(
    "/build",
    response_class=Response,
    responses={
        200: {
            "model": FunctionJson,
            "description": "The Function JSON, byte for byte as `sigcat function build` writes it.",
            "headers": {
                "Sigcat-Warnings": {"description": "How many warnings there are.", "schema": {"type": "integer"}}
            },
        },
        **problem_documentation(404, 413, 415, 422),
    },
    openapi_extra=text_body("The declaration of a function, as it stands in `function.yaml`.", _DECLARATION),
)
def build_function_json(text: PostedText, hosted: NamedCatalogue, name: FileName = "function.yaml") -> Response:
    """Resolve a declaration against a catalogue. To see the warnings, lint the same text with `kind=function`."""
    function, findings = build_function(text, name, hosted.catalogue)
    return Response(to_json(function), media_type="application/json", headers={"Sigcat-Warnings": str(len(findings))})


@router.post(
    "/validate",
    responses=problem_documentation(404, 413, 415, 422),
    openapi_extra=text_body("A Function JSON from anywhere.", ""),
)
def validate_function(text: PostedText, hosted: NamedCatalogue, name: FileName = "function.json") -> schemas.LintReport:
    """Check a Function JSON. Errors make it unusable; warnings are departures from the conventions."""
    return lint_report(validate_function_json(text, name, hosted.catalogue))
