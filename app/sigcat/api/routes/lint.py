"""The route that lints a posted text."""

from typing import Annotated

from fastapi import APIRouter, Query
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.named_types import TextKind
from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.answers.serializers import lint_report
from sigcat.api.requests.dependencies import FileName, ThePostedWork, TheRules, takes_text
from sigcat.api.requests.function_files import SET
from sigcat.api.routes.changes import OVERLAY
from sigcat.api.routes.functions import check_posted
from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.limits import Limits

router = APIRouter(prefix="/api/v1", tags=["lint"])

_BODY = f"An overlay, a tree or a function: the text of its file; or, as functions, a set: {SET}."


@router.post("/lint", response_model=schemas.LintReport, **takes_text(_BODY, OVERLAY, 404))
async def lint(
    work: ThePostedWork,
    rules: TheRules,
    kind: Annotated[
        TextKind, Query(description="An overlay over the catalogue, a tree by itself, or functions.")
    ] = "overlay",
    name: FileName = "posted.vspec",
) -> Response:
    """Check a text against the rules of the project; without one, those that are on by default. The text is not stored."""
    return Response(await work.run(_report, name, kind, rules), media_type=JSON)


def _report(text: bytes, name: str, catalogue: Catalogue, limits: Limits, kind: TextKind, rules: ServiceRules) -> bytes:
    if kind == "function":
        findings = check_posted(text, name, catalogue, limits)
    else:
        findings = rules.findings_in_text(text, name, catalogue, limits, is_tree=kind == "tree")
    return json_bytes(lint_report(findings))
