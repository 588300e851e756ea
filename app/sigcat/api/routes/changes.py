"""Routes for what changed, and what an overlay would change."""

from collections.abc import Collection
from typing import Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.named_types import Compatibility
from sigcat.api.answers.negotiation import (
    JSON,
    YAML,
    caching_headers,
    chosen_type,
    json_bytes,
    written,
)
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import diff_schema, trial_schema
from sigcat.api.answers.versions import version_of
from sigcat.api.requests.dependencies import (
    AnyCatalogue,
    CatalogueId,
    FileName,
    PostedText,
    TheLibrary,
    TheSettings,
    TheWorkQueue,
    catalogue_at,
    judge_conditions,
    mark_state,
    text_body,
)
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.diff_report import markdown_report, text_report
from sigcat.catalogue.comparing.trial import try_overlay as tried
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.limits import NAME_CHARACTERS, PARAMETER_VALUES, Limits

router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["changes"])

MARKDOWN, TEXT = "text/markdown", "text/plain"
_FORMS = (JSON, YAML, MARKDOWN, TEXT)
_OVERLAY = """\
Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  max: 300
"""


@router.get(
    "/diff",
    response_model=schemas.Diff,
    responses={
        200: {
            "description": "Every change, in the order of the paths.",
            "content": {YAML: {}, **{form: {"schema": {"type": "string"}} for form in (MARKDOWN, TEXT)}},
        },
        **problem_documentation(404, 406, 422, 503),
    },
)
async def diff_catalogues(
    request: Request,
    catalogue: CatalogueId,
    library: TheLibrary,
    queue: TheWorkQueue,
    to: Annotated[
        str, Query(description="Id of the newer catalogue.", examples=["interfaces"], max_length=NAME_CHARACTERS)
    ],
    compatibility: Annotated[
        list[Compatibility] | None,
        Query(max_length=PARAMETER_VALUES, description="Classes to show; all without it."),
    ] = None,
) -> Response:
    """Return the changes from one hosted catalogue to another, with whom they break."""
    old, is_old_fixed = await catalogue_at(catalogue, library, queue)
    new, is_new_fixed = await catalogue_at(to, library, queue)
    mark_state(request, f"{version_of(old)}-{version_of(new)}", is_fixed=is_old_fixed and is_new_fixed)
    judge_conditions(request)
    form = chosen_type(request.headers.get("accept", "*/*"), _FORMS)
    names = old.source.id, new.source.id
    report = await queue.run(_report, old.catalogue, new.catalogue, names, compatibility, form)
    return Response(report, media_type=form, headers=caching_headers(request))


@router.post(
    "/trial",
    response_model=schemas.Trial,
    responses=problem_documentation(404, 408, 413, 415, 422, 503),
    openapi_extra=text_body("An overlay: the text of its file. It cannot include others.", _OVERLAY),
)
async def try_overlay(
    text: PostedText,
    hosted: AnyCatalogue,
    settings: TheSettings,
    queue: TheWorkQueue,
    name: FileName = "posted.vspec",
) -> Response:
    """Apply an overlay to a catalogue and return the resulting nodes, findings and changes. Nothing is stored."""

    trial = await queue.run(_trial, hosted.catalogue, text, name, settings.limits, settings.results)
    return Response(trial, media_type=JSON)


def _report(
    old: Catalogue, new: Catalogue, names: tuple[str, str], classes: Collection[Compatibility] | None, form: str
) -> bytes:
    """The changes of these classes, or of all, in one of the forms."""
    changes = compare(old, new)
    shown = [change for change in changes if not classes or change.compatibility in classes]
    hidden = len(changes) - len(shown)
    if form == MARKDOWN:
        return markdown_report(shown, *names, hidden).encode("utf-8", "replace")
    if form == TEXT:
        return text_report(shown, hidden=hidden).encode("utf-8", "replace")
    return written(diff_schema(shown, *names), form)


def _trial(catalogue: Catalogue, text: bytes, name: str, limits: Limits, most_nodes: int) -> bytes:
    return json_bytes(trial_schema(tried(catalogue, text, name, limits), most_nodes))
