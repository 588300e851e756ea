"""Routes for what changed, and what an overlay would change."""

from collections.abc import Collection
from typing import Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from sigcat.api.answers import schemas
from sigcat.api.answers.named_types import Binding, Compatibility
from sigcat.api.answers.negotiation import JSON, YAML, caching_headers, chosen_type, json_bytes, written
from sigcat.api.answers.problems import problem_documentation, reads
from sigcat.api.answers.serializers import diff_schema, history_schema, trial_schema
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
    takes_text,
)
from sigcat.api.routes.catalogues import NodePath, node_at
from sigcat.catalogue.comparing.bindings import chosen, for_bindings
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.diff_report import markdown_report, text_report
from sigcat.catalogue.comparing.trial import try_overlay as tried
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import expanded_of, instances_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.digest import digest_of
from sigcat.limits import NAME_CHARACTERS, PARAMETER_VALUES, Limits
from sigcat.migration.node_history import NodeHistory, instance_of, node_history, official_releases

router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["changes"])

MARKDOWN, TEXT = "text/markdown", "text/plain"
_FORMS = (JSON, YAML, MARKDOWN, TEXT)
OVERLAY = """\
Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  max: 300
"""
"""An overlay over the shipped catalogue."""


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
    binding: Annotated[
        list[Binding] | None,
        Query(
            max_length=PARAMETER_VALUES,
            description="Give each change the worst of its classes for software that uses these bindings.",
        ),
    ] = None,
) -> Response:
    """Return the changes from one hosted catalogue to another, with whom they break."""
    old, is_old_fixed = await catalogue_at(catalogue, library, queue)
    new, is_new_fixed = await catalogue_at(to, library, queue)
    mark_state(request, f"{version_of(old)}-{version_of(new)}", is_fixed=is_old_fixed and is_new_fixed)
    judge_conditions(request)
    form = chosen_type(request.headers.get("accept", "*/*"), _FORMS)
    names = old.source.id, new.source.id
    report = await queue.run(_report, old.catalogue, new.catalogue, names, compatibility, binding, form)
    return Response(report, media_type=form, headers=caching_headers(request))


@router.get("/nodes/{path}/history", **reads(schemas.NodeHistory, 404, 422, 503))
async def get_node_history(
    request: Request, hosted: AnyCatalogue, path: NodePath, library: TheLibrary, queue: TheWorkQueue
) -> Response:
    """What happened to a node in the hosted releases of VSS: where it was added, changed, moved and removed."""
    await node_at(request, hosted.catalogue, path)
    mark_state(request, state_of_releases(hosted, library), is_fixed=False)
    judge_conditions(request)
    form = chosen_type(request.headers.get("accept", "*/*"), (JSON, YAML))
    report = await queue.run(_history, hosted.catalogue, path, library, form)
    return Response(report, media_type=form, headers=caching_headers(request))


@router.post(
    "/trial",
    response_model=schemas.Trial,
    **takes_text("An overlay: the text of its file. It cannot include others.", OVERLAY, 404),
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
    old: Catalogue,
    new: Catalogue,
    names: tuple[str, str],
    classes: Collection[Compatibility] | None,
    bindings: Collection[str] | None,
    form: str,
) -> bytes:
    """The changes of these classes, or of all, in one of the forms."""
    changes = for_bindings(compare(old, new), chosen(bindings or ()))
    shown = [change for change in changes if not classes or change.compatibility in classes]
    hidden = len(changes) - len(shown)
    if form == MARKDOWN:
        return markdown_report(shown, *names, hidden).encode("utf-8", "replace")
    if form == TEXT:
        return text_report(shown, hidden=hidden).encode("utf-8", "replace")
    return written(diff_schema(shown, *names), form)


def state_of_releases(hosted: Hosted, library: Library) -> str:
    """Return the state that the history of a node depends on: that of its catalogue, and of all releases."""
    releases = digest_of("".join(version_of(each) for each in library).encode())
    return f"{version_of(hosted)}-{releases[:24]}"


def _history(catalogue: Catalogue, path: str, library: Library, form: str) -> bytes:
    return written(history_schema(hosted_history(path, catalogue, library)), form)


def hosted_history(path: str, catalogue: Catalogue, library: Library) -> NodeHistory:
    """The history of a node over the hosted releases; of folded instances, that of the first one."""
    releases = official_releases((each.source, each.catalogue) for each in library)
    return node_history(instance_of(path, instances_of(catalogue, path)), expanded_of(catalogue), releases)


def _trial(catalogue: Catalogue, text: bytes, name: str, limits: Limits, most_nodes: int) -> bytes:
    return json_bytes(trial_schema(tried(catalogue, text, name, limits), most_nodes))
