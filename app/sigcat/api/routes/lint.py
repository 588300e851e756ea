"""The route that lints a posted text."""

from typing import Annotated

from fastapi import APIRouter, Query
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.named_types import TextKind
from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import lint_report
from sigcat.api.requests.dependencies import (
    FileName,
    NamedCatalogue,
    PostedText,
    TheRules,
    TheSettings,
    TheWorkQueue,
    text_body,
)
from sigcat.api.requests.function_files import SET
from sigcat.api.routes.functions import check_posted
from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.limits import Limits

router = APIRouter(prefix="/api/v1", tags=["lint"])

_BODY = f"An overlay, a tree or a function: the text of its file; or, as functions, a set: {SET}."
_EXAMPLE = """\
Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  max: 300
"""


@router.post(
    "/lint",
    response_model=schemas.LintReport,
    responses=problem_documentation(404, 408, 413, 415, 422, 503),
    openapi_extra=text_body(_BODY, _EXAMPLE),
)
async def lint(
    text: PostedText,
    hosted: NamedCatalogue,
    rules: TheRules,
    settings: TheSettings,
    queue: TheWorkQueue,
    kind: Annotated[
        TextKind,
        Query(description="An overlay over the catalogue, a tree by itself, or functions."),
    ] = "overlay",
    name: FileName = "posted.vspec",
) -> Response:
    """Check a text against the rules of the project; without one, those that are on by default. The text is not stored."""
    report = await queue.run(_report, kind, text, name, hosted.catalogue, rules, settings.limits)
    return Response(report, media_type=JSON)


def _report(kind: TextKind, text: bytes, name: str, catalogue: Catalogue, rules: ServiceRules, limits: Limits) -> bytes:
    if kind == "function":
        findings = check_posted(text, name, catalogue, limits)
    else:
        findings = rules.findings_in_text(text, name, catalogue, limits, is_tree=kind == "tree")
    return json_bytes(lint_report(findings))
