"""A page for writing an overlay, a tree or a function, which shows its errors at once."""

from functools import partial
from typing import Annotated, Literal, NamedTuple

from fastapi import APIRouter, Query
from fastapi.responses import Response

from sigcat.api.requests.dependencies import TheWorkQueue
from sigcat.api.service_rules import ServiceRules
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import OVERLAYS
from sigcat.errors import NotFound, UsageError
from sigcat.file_kind import holds_function, is_json
from sigcat.findings import Finding
from sigcat.function.declaration.scaffold import scaffold
from sigcat.function.function_file import check_function_json, checked_file
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_files import FILE, HostedFiles
from sigcat.function.hosting import file_of
from sigcat.limits import Limits
from sigcat.web.pages.checked_text import Asked, Posted, TheAsked, ThePosted, text_values
from sigcat.web.pictures.interface_diagram import interface_diagram
from sigcat.web.pictures.timeline import time_line
from sigcat.web.rendering import page_for
from sigcat.web.views.command_lines import overlay_commands
from sigcat.web.views.document_tabs import TABS, chosen_tab, download, open_tab
from sigcat.web.views.generated_documents import documents_of
from sigcat.web.views.proposing.overlay_outcome import OverlayOutcome, overlay_outcome
from sigcat.web.views.source_view import shown_text

router = APIRouter()
Kind = Literal["overlay", "function", "tree"]
KINDS: dict[Kind, str] = {"overlay": "Overlay", "function": "Function", "tree": "Tree"}
_TITLES = {"interfaces": "Interfaces", **{name: tab.title for name, tab in TABS.items()}}
_EXAMPLE = "core_acc"
_OVERLAY = """\
# An overlay changes or adds nodes. Findings appear as you type.
Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  min: 0
  max: 300
  ASILlevel: B
  description: Speed of the vehicle along its direction of travel.

Vehicle.Chassis.brake_fluid_level:
  type: sensor
  datatype: uint8
  unit: percnt
  max: 100
"""
_TREE = """\
Vehicle:
  type: branch
  description: Everything about one vehicle.

Vehicle.Speed:
  type: sensor
  datatype: float
  unit: km/h
  description: Speed of the vehicle along its direction of travel.
"""


class Tried(NamedTuple):
    """Results for a text: findings, the function that it declares, and its effects as an overlay."""

    findings: tuple[Finding, ...]
    resolved: ResolvedFunction | None = None
    outcome: OverlayOutcome | None = None


@router.get("/try")
async def show_try(
    asked: TheAsked,
    queue: TheWorkQueue,
    kind: Kind = "overlay",
    example: Annotated[str, Query(max_length=100)] = "",
) -> Response:
    """The page with a text to begin with: a hosted function, a shipped overlay, or a few lines."""
    return await queue.run(_begun, asked, kind, example)


@router.post("/try")
async def try_text(queue: TheWorkQueue, posted: ThePosted) -> Response:
    """The page with what was found in the posted text, or a document made of it. The text is not stored."""
    return await queue.run(_tried_form, posted)


def _begun(asked: Asked, kind: Kind, example: str) -> Response:
    text = _beginning(kind, example, asked)
    return _page(asked, kind, text, _judged(asked, kind, text.encode("utf-8", "replace")))


def _tried_form(posted: Posted) -> Response:
    asked, form = posted.read()
    given = form.last("kind", "overlay")
    kind = next((each for each in KINDS if each == given), None)
    if kind is None:
        raise UsageError(f"The kind must be {' or '.join(KINDS)}, not {given[:100]!r}.")
    data = form.files[0].data if form.files else form.text("text").encode("utf-8", "replace")
    result = _judged(asked, kind, data)
    if form.last("download"):
        return _download(result.resolved, form.last("download"))
    return _page(asked, kind, shown_text(data), result, form.last("view", "interfaces"))


def _download(function: ResolvedFunction | None, document_id: str) -> Response:
    if function is None:
        raise NotFound(f"Unknown document {document_id[:100]!r}.")
    return download(document_id, function.name, partial(documents_of, function), TABS)


def rehearse(catalogue: Catalogue, rules: ServiceRules, files: HostedFiles, limits: Limits) -> None:
    """Try the text that the page begins with, as whoever types next does."""
    _outcome(_OVERLAY.encode(), "overlay", catalogue, rules, files, limits)


def _judged(asked: Asked, kind: Kind, data: bytes) -> Tried:
    return _outcome(data, kind, asked.hosted.catalogue, asked.rules, asked.files, asked.limits)


def _outcome(
    data: bytes, kind: Kind, catalogue: Catalogue, rules: ServiceRules, files: HostedFiles, limits: Limits
) -> Tried:
    result = tried(data, kind, catalogue, rules, limits)
    if kind != "overlay" or holds_function(data):
        return result
    return result._replace(outcome=overlay_outcome(data, expanded_of(catalogue), files, limits))


def tried(data: bytes, kind: Kind, catalogue: Catalogue, rules: ServiceRules, limits: Limits) -> Tried:
    """Return the findings in a text, and the function that it declares."""
    if kind != "function":
        return Tried(rules.findings_in_text(data, "posted.vspec", catalogue, limits, is_tree=kind == "tree"))
    if is_json(data, FILE):
        document = check_function_json(data, "function.json", catalogue, limits)
        return Tried(document.findings, document.resolved)
    declaration = checked_file(data, FILE, catalogue, limits)
    return Tried(declaration.findings, declaration.sound)


def _page(asked: Asked, kind: Kind, text: str, result: Tried, view: str = "interfaces") -> Response:
    hosted = asked.hosted
    resolved, shown = result.resolved, chosen_tab(view, _TITLES, TABS)
    function = resolved.function if resolved else None
    return page_for(
        asked.visit,
        "try.html",
        **text_values(hosted, text, result.findings, result.outcome, is_folded=kind != "function"),
        kind=kind,
        kinds=KINDS,
        function=function,
        diagram=interface_diagram(function) if function else None,
        timeline=time_line([function]) if function else None,
        tabs=_TITLES,
        tab=shown,
        view=view,
        opened=open_tab(view, TABS[shown], partial(documents_of, resolved)) if resolved and shown in TABS else None,
        commands=overlay_commands(hosted) if result.outcome else (),
    )


def _beginning(kind: Kind, example: str, asked: Asked) -> str:
    files, catalogue = asked.files, asked.hosted.catalogue
    roots = catalogue.roots
    if kind == "function":
        known = [file.id for file in files]
        chosen = example or (_EXAMPLE if _EXAMPLE in known else next(iter(known), ""))
        return shown_text(file_of(files, chosen).data) if chosen else scaffold("NewFunction", catalogue=catalogue)
    if kind == "overlay" and example:
        shipped = {path.stem: path for path in OVERLAYS.glob("*.vspec")}
        if example in shipped:
            return shipped[example].read_text("utf-8")
    return _TREE if kind == "tree" else _OVERLAY.replace("Vehicle.", f"{roots[0].name if roots else 'Vehicle'}.")
