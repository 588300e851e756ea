"""Changes of the registry in the browser: publish files, decide about pending versions, end versions, send events again."""

import datetime as dt
from functools import partial
from http import HTTPStatus
from typing import TYPE_CHECKING

from fastapi import APIRouter, Request
from fastapi.responses import RedirectResponse, Response

from sigcat.api.answers.problems import problem_from
from sigcat.api.middleware.registry_access import author_of
from sigcat.api.requests.dependencies import TheSettings, TheWorkQueue
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import InThread, in_thread
from sigcat.api.routes.registry_writing import in_turn
from sigcat.catalogue.hosting.library import Library
from sigcat.errors import InputRefused, UsageError
from sigcat.limits import REGISTRY_REQUEST_SECONDS, Limits
from sigcat.names import either
from sigcat.web.forms import Form, form_catalogue
from sigcat.web.registry_visits import OwnSite, RegistryVisit, SignedForm, SignedIn, field
from sigcat.web.rendering import page_for

if TYPE_CHECKING:
    from sigcat.registry.candidate import Candidate
    from sigcat.registry.reference import Kind, Reference

router = APIRouter(route_class=InThread)


@router.get("/registry/publish")
def show_publish(visit: RegistryVisit, _: SignedIn) -> Response:
    """The form for files."""
    return page_for(visit, "registry_publish.html", outcomes=None, problem=None, form=Form(()))


@router.post("/registry/publish", dependencies=[OwnSite])
async def publish_files(
    request: Request,
    registry: TheRegistry,
    settings: TheSettings,
    queue: TheWorkQueue,
    visit: RegistryVisit,
    session: SignedIn,
    form: SignedForm,
) -> Response:
    """Publish all files of the form, or none, and list what became of them. A refused form keeps its values."""
    from sigcat.registry.publish import publish
    from sigcat.registry.storing.entry import now

    author = author_of(session.token, "publish")
    owner = field(form, "owner") or author.owner
    version, is_draft = field(form, "version"), bool(form.last("draft"))
    try:
        candidates = await queue.run(_candidates, form, visit.library, version, owner, settings.limits)
        receipt = await in_turn(request, lambda: publish(registry.written_by(author), candidates, is_draft=is_draft))
    except (InputRefused, UsageError) as error:
        problem = problem_from(error)
        return await in_thread(
            request, page_for, visit, "registry_publish.html", problem.status, outcomes=None, problem=problem, form=form
        )
    published = partial(page_for, outcomes=receipt.outcomes, problem=None, form=Form(()), now=now())
    return await in_thread(request, published, visit, "registry_publish.html")


@router.post("/registry/decide", dependencies=[OwnSite])
async def decide(
    request: Request, registry: TheRegistry, visit: RegistryVisit, session: SignedIn, form: SignedForm
) -> Response:
    """Approve or reject the content of a pending version."""
    from sigcat.registry.approvals import approve, reject

    author = author_of(session.token, "approve")
    kind, reference = _version(form)
    owner, content = field(form, "owner") or author.owner, field(form, "content")
    registry_of_author = registry.written_by(author)
    if _chosen(form, "approve", "reject") == "approve":
        await in_turn(request, lambda: approve(registry_of_author, kind, reference, owner, content=content))
    else:
        reason = form.last("reason")
        await in_turn(request, lambda: reject(registry_of_author, kind, reference, owner, reason, content))
    return RedirectResponse(f"{visit.below}/registry#pending", HTTPStatus.SEE_OTHER)


@router.post("/registry/acknowledge", dependencies=[OwnSite])
async def acknowledge_deprecation(
    request: Request, registry: TheRegistry, visit: RegistryVisit, session: SignedIn, form: SignedForm
) -> Response:
    """Record that an owner knows of a deprecation."""
    from sigcat.registry.acknowledgements import acknowledge

    author = author_of(session.token, "approve")
    kind, reference = _version(form)
    owner = field(form, "owner") or author.owner
    await in_turn(request, lambda: acknowledge(registry.written_by(author), kind, reference, owner))
    return RedirectResponse(f"{visit.below}/registry#deprecated", HTTPStatus.SEE_OTHER)


@router.post("/registry/end", dependencies=[OwnSite])
async def end_version(
    request: Request, registry: TheRegistry, visit: RegistryVisit, session: SignedIn, form: SignedForm
) -> Response:
    """Deprecate or retire a version."""
    from sigcat.registry.lines import set_state

    author = author_of(session.token, "publish")
    kind, reference = _version(form)
    written = registry.written_by(author)
    if _chosen(form, "deprecate", "retire") == "deprecate":
        until, successor = field(form, "until"), field(form, "successor")
        await in_turn(request, lambda: set_state(written, kind, reference, "deprecated", until, successor))
    else:
        await in_turn(request, lambda: set_state(written, kind, reference, "retired"))
    return RedirectResponse(f"{visit.below}/registry/{kind}s/{reference.name}", HTTPStatus.SEE_OTHER)


@router.post("/registry/redeliver", dependencies=[OwnSite])
async def redeliver_event(
    request: Request, registry: TheRegistry, visit: RegistryVisit, session: SignedIn, form: SignedForm
) -> Response:
    """Let `sigcat registry deliver` send an event to a webhook again."""
    author_of(session.token, "administer")
    await in_turn(request, lambda: _redeliver(registry, field(form, "delivery")))
    return RedirectResponse(f"{visit.below}/registry/deliveries", HTTPStatus.SEE_OTHER)


def _redeliver(registry: HostedRegistry, delivery: str) -> None:
    from sigcat.registry.storing.database import writing
    from sigcat.registry.webhooks.deliveries import redeliver

    with writing(registry.present(), REGISTRY_REQUEST_SECONDS) as connection:
        redeliver(connection, delivery, dt.datetime.now(dt.UTC))


def _version(form: Form) -> "tuple[Kind, Reference]":
    from sigcat.registry.reference import reference_of
    from sigcat.web.views.registry_view import GROUPS

    kind = GROUPS.get(field(form, "group"))
    if kind is None:
        raise UsageError(f"The group must be {either(GROUPS)}, not {field(form, 'group')[:80]!r}.")
    return kind, reference_of(field(form, "reference"))


def _chosen(form: Form, *actions: str) -> str:
    """The button of a form that was pressed. Raises UsageError."""
    given = field(form, "action")
    if given not in actions:
        raise UsageError(f"The action must be {either(actions)}, not {given[:80]!r}.")
    return given


def _candidates(form: Form, library: Library, version: str, owner: str, limits: Limits) -> "tuple[Candidate, ...]":
    from sigcat.registry.posted import posted_candidates

    if not form.files:
        raise UsageError("No file is chosen. Choose a function or an overlay.")
    files = [(each.data, each.name) for each in form.files]
    return posted_candidates(files, form_catalogue(form, library).catalogue, version, owner, limits)
