"""Routes that take a function from its declaration to Function JSON."""

from typing import Any

from fastapi import APIRouter
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.answers.serializers import lint_report
from sigcat.api.requests.dependencies import FileName, ThePostedWork, takes_text
from sigcat.api.requests.function_files import SET, posted_functions
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.function_file import build_function, check_function
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.sets.check_set import check_functions
from sigcat.limits import Limits

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
_BUILT: dict[int | str, dict[str, Any]] = {
    200: {
        "model": FunctionJson,
        "description": "The Function JSON, byte for byte as `sigcat function build` writes it.",
        "headers": {"Sigcat-Warnings": {"description": "How many warnings there are.", "schema": {"type": "integer"}}},
    }
}


@router.post(
    "/build",
    response_class=Response,
    **takes_text("The declaration of a function: the text of `function.yaml`.", DECLARATION, 404, answers=_BUILT),
)
async def build_function_json(work: ThePostedWork, name: FileName = "function.yaml") -> Response:
    """Resolve a declaration against a catalogue. To see the warnings, lint the same text with `kind=function`."""
    function_json, warnings = await work.run(_built, name)
    return Response(function_json, media_type=JSON, headers={"Sigcat-Warnings": str(warnings)})


@router.post(
    "/validate",
    response_model=schemas.LintReport,
    **takes_text(f"A function file from anywhere; or several, which are checked together: {SET}.", "", 404),
)
async def validate_function(work: ThePostedWork, name: FileName = "function") -> Response:
    """Check functions, alone and together. Errors make them unusable; warnings are departures from the conventions.

    The text is Function JSON unless its `name` ends otherwise.
    """
    return Response(await work.run(_report, name), media_type=JSON)


def _built(text: bytes, name: str, catalogue: Catalogue, limits: Limits) -> tuple[bytes, int]:
    """The Function JSON, and how many warnings there are."""
    function, findings = build_function(text, name, catalogue, limits)
    return to_json(function), len(findings)


def _report(text: bytes, name: str, catalogue: Catalogue, limits: Limits) -> bytes:
    return json_bytes(lint_report(check_posted(text, name, catalogue, limits)))


def check_posted(text: bytes, name: str, catalogue: Catalogue, limits: Limits) -> tuple[Finding, ...]:
    """Everything that is wrong with the function of a body, or with those of a set, alone and together."""
    try:
        posted = posted_functions(text, name, limits)
    except InputRefused as error:
        return error.findings
    if posted.is_set:
        return check_functions(posted.files, catalogue, limits, is_whole=len(posted.files) > 1)
    return check_function(text, name, catalogue, limits)
