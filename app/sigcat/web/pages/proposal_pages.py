"""A change that is proposed from the page of a node: in a form or as text, with its findings and effects, as overlay or patch."""

from http import HTTPStatus
from typing import Annotated, Literal

from fastapi import APIRouter, Query
from fastapi.responses import RedirectResponse, Response

from sigcat.api.requests.dependencies import TheWorkQueue
from sigcat.api.routes.catalogues import find_node
from sigcat.catalogue.hosting.library import Hosted
from sigcat.errors import UsageError
from sigcat.function.node_uses import uses_in
from sigcat.limits import PARAMETER_CHARACTERS
from sigcat.web.addresses import Addresses
from sigcat.web.forms import Form
from sigcat.web.pages.checked_text import Asked, Posted, TheAsked, ThePosted, text_values
from sigcat.web.rendering import page_for, text_file
from sigcat.web.views.command_lines import overlay_commands
from sigcat.web.views.proposing.overlay_outcome import overlay_outcome
from sigcat.web.views.proposing.proposal import Proposal, adding, changing, posted_fields, types_for
from sigcat.web.views.proposing.proposal_patch import proposal_patch

router = APIRouter()
Mode = Literal["form", "text"]
Path = Annotated[str, Query(max_length=PARAMETER_CHARACTERS)]
_NO_EFFECT = "overlay-no-effect"
"""The check of rules that report an overlay without a change: here nothing is changed at first."""


@router.get("/propose")
async def show_proposal(
    asked: TheAsked,
    queue: TheWorkQueue,
    change: Path = "",
    below: Path = "",
    mode: Annotated[Mode, Query(alias="as")] = "form",
) -> Response:
    """The page for a node to change, or to add one below or beside; without a node, the page to try any overlay."""
    if not (change or below):
        to = Addresses(asked.visit.below)
        return RedirectResponse(to.page("try") + to.query({"catalogue": asked.hosted.source.id}), HTTPStatus.SEE_OTHER)
    return await queue.run(_begun, asked, Form((("change", change), ("below", below), ("as", mode))))


@router.post("/propose")
async def propose(queue: TheWorkQueue, posted: ThePosted) -> Response:
    """The page with the findings and effects of what was entered, or a file of it. Nothing is stored."""
    return await queue.run(_posted, posted)


def _posted(posted: Posted) -> Response:
    return _begun(*posted.read())


def _begun(asked: Asked, form: Form) -> Response:
    proposal = _proposal(asked.hosted, form)
    is_text = form.last("as") == "text"
    text = form.text("text") if is_text and form.every("text") else _begun_text(proposal, form, is_text=is_text)
    data = text.encode("utf-8", "replace")
    match form.last("download"):
        case "overlay":
            return text_file(f"# Proposed change of {asked.hosted.source.title}\n{text}", "overlay.vspec", "text/plain")
        case "patch":
            patch = proposal_patch(asked.hosted.catalogue, data, asked.limits)
            if not patch:
                raise UsageError("Nothing is changed yet: a patch would be empty.")
            return text_file(patch, "proposal.patch", "text/x-patch")
    return _page(asked, form, proposal, text, "text" if is_text else "form")


def _begun_text(proposal: Proposal, form: Form, *, is_text: bool) -> str:
    """The text of the fields; as text to begin with, all that the node says."""
    return (
        proposal.whole_text if is_text and not any(name.startswith("a.") for name, _ in form.fields) else proposal.text
    )


def _proposal(hosted: Hosted, form: Form) -> Proposal:
    change, below = form.last("change"), form.last("below")
    if not (change or below):
        raise UsageError("The form must name a node to change, or one to add a node below.")
    node = find_node(hosted.catalogue, change or below)
    given = posted_fields(dict(form.fields))
    return changing(node, given) if change else adding(hosted.catalogue, node, form.last("name").strip(), given)


def _page(asked: Asked, form: Form, proposal: Proposal, text: str, mode: Mode) -> Response:
    hosted, data = asked.hosted, text.encode("utf-8", "replace")
    without_effect = {rule.id for rule in asked.rules.active.rules if rule.check == _NO_EFFECT}
    found = asked.rules.findings_in_text(data, "posted.vspec", hosted.catalogue, asked.limits)
    findings = tuple(each for each in found if each.rule not in without_effect)
    outcome = overlay_outcome(data, asked.catalogue, asked.files, asked.limits)
    return page_for(
        asked.visit,
        "propose.html",
        **text_values(hosted, text, findings, outcome, is_folded=True),
        change=form.last("change"),
        below=form.last("below"),
        mode=mode,
        proposal=proposal,
        name=proposal.path.rpartition(".")[2],
        types=types_for(proposal),
        units=[unit.key for unit in hosted.catalogue.vocabulary.distinct_units],
        uses=uses_in(asked.files, hosted.catalogue).of_node.get(form.last("change"), ()),
        function=None,
        commands=overlay_commands(hosted),
    )
