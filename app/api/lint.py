"""The route that lints a posted text."""

from functools import partial
from typing import Annotated, Literal

from fastapi import APIRouter, Query
from fastapi.responses import Response

from app.api import schemas
from app.api.answers import json_answer
from app.api.presenting import lint_report
from app.api.problems import problem_documentation
from app.api.requests import FileName, NamedCatalogue, PostedText, TheHeavyWork, TheRules, text_body
from app.function.build import check_function
from app.rules.lint import lint_text

router = APIRouter(prefix="/api/v1", tags=["lint"])

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
    openapi_extra=text_body("An overlay, a tree or a declaration of a function, as it stands in its file.", _EXAMPLE),
)
async def lint(
    text: PostedText,
    hosted: NamedCatalogue,
    rules: TheRules,
    heavy: TheHeavyWork,
    kind: Annotated[
        Literal["overlay", "tree", "function"],
        Query(description="An overlay over the catalogue, a tree by itself, or the declaration of a function."),
    ] = "overlay",
    name: FileName = "posted.vspec",
) -> Response:
    """Check a text against the rules that are on by default. Nothing of it is kept."""
    if kind == "function":
        work = partial(check_function, text, name, hosted.catalogue)
    else:
        work = partial(lint_text, text, name, hosted.catalogue, rules.active, is_tree=kind == "tree")
    return json_answer(lint_report(await heavy.run(work)))
