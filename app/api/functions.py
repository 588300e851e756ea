"""Routes that take a function from its declaration to Function JSON."""

from functools import partial

from fastapi import APIRouter
from fastapi.responses import Response

from app.api import schemas
from app.api.presenting import lint_report
from app.api.problems import problem_documentation
from app.api.requests import FileName, NamedCatalogue, PostedText, TheHeavyWork, text_body
from app.function.build import build_function
from app.function.model import FunctionJson, to_json
from app.function.validate import validate_function_json

router = APIRouter(prefix="/api/v1/functions", tags=["functions"])

DECLARATION = """\
function: WheelSpeedCalculation
version: 1.0.0
responsible: Chassis
description: Turns the rotation of the four wheels into their speeds over ground.
components:
  - name: WheelSpeedCalculation
    runnables:
      - WheelSpeedCalculation_Init
      - WheelSpeedCalculation_Terminate
"""
"""A declaration that can be built against the shipped catalogue."""


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
        **problem_documentation(404, 408, 413, 415, 422, 503),
    },
    openapi_extra=text_body("The declaration of a function, as it stands in `function.yaml`.", DECLARATION),
)
async def build_function_json(
    text: PostedText, hosted: NamedCatalogue, heavy: TheHeavyWork, name: FileName = "function.yaml"
) -> Response:
    """Resolve a declaration against a catalogue. To see the warnings, lint the same text with `kind=function`."""
    function, findings = await heavy.run(partial(build_function, text, name, hosted.catalogue))
    return Response(to_json(function), media_type="application/json", headers={"Sigcat-Warnings": str(len(findings))})


@router.post(
    "/validate",
    responses=problem_documentation(404, 408, 413, 415, 422, 503),
    openapi_extra=text_body("A Function JSON from anywhere.", ""),
)
async def validate_function(
    text: PostedText, hosted: NamedCatalogue, heavy: TheHeavyWork, name: FileName = "function.json"
) -> schemas.LintReport:
    """Check a Function JSON. Errors make it unusable; warnings are departures from the conventions."""
    return lint_report(await heavy.run(partial(validate_function_json, text, name, hosted.catalogue)))
