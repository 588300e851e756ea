"""The route that lints a posted text."""

from functools import partial
from typing import Annotated, Literal

from fastapi import APIRouter, Query
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import json_answer
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
from sigcat.rules.linting.posted import lint_text

router = APIRouter(prefix="/api/v1", tags=["lint"])

_BODY = f"An overlay, a tree or a function, as it stands in its file; or, as functions, a set: {SET}."
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
        Literal["overlay", "tree", "function"],
        Query(description="An overlay over the catalogue, a tree by itself, or functions."),
    ] = "overlay",
    name: FileName = "posted.vspec",
) -> Response:
    """Check a text against the rules that are on by default. Nothing of it is kept."""
    if kind == "function":
        work = partial(check_posted, text, name, hosted.catalogue, settings.limits)
    else:
        is_tree = kind == "tree"
        work = partial(lint_text, text, name, hosted.catalogue, rules.active, is_tree=is_tree, limits=settings.limits)
    return json_answer(lint_report(await queue.run(work)))
