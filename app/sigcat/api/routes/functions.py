"""Routes that take a function from its declaration to Function JSON."""

from fastapi import APIRouter
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import lint_report
from sigcat.api.requests.dependencies import FileName, NamedCatalogue, PostedText, TheSettings, TheWorkQueue, text_body
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
    openapi_extra=text_body("The declaration of a function: the text of `function.yaml`.", DECLARATION),
)
async def build_function_json(
    text: PostedText,
    hosted: NamedCatalogue,
    settings: TheSettings,
    queue: TheWorkQueue,
    name: FileName = "function.yaml",
) -> Response:
    """Resolve a declaration against a catalogue. To see the warnings, lint the same text with `kind=function`."""

    function_json, warnings = await queue.run(_built, text, name, hosted.catalogue, settings.limits)
    return Response(function_json, media_type=JSON, headers={"Sigcat-Warnings": str(warnings)})


@router.post(
    "/validate",
    response_model=schemas.LintReport,
    responses=problem_documentation(404, 408, 413, 415, 422, 503),
    openapi_extra=text_body(f"A function file from anywhere; or several, which are checked together: {SET}.", ""),
)
async def validate_function(
    text: PostedText,
    hosted: NamedCatalogue,
    settings: TheSettings,
    queue: TheWorkQueue,
    name: FileName = "function",
) -> Response:
    """Check functions, alone and together. Errors make them unusable; warnings are departures from the conventions.

    The text is Function JSON unless its `name` ends otherwise.
    """

    return Response(await queue.run(_report, text, name, hosted.catalogue, settings.limits), media_type=JSON)


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
