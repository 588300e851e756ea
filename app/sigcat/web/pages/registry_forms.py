"""Changes of the registry in the browser: publish files, decide about pending versions, end versions, send events again."""

import datetime as dt
from collections.abc import Awaitable, Callable
from functools import partial
from http import HTTPStatus
from typing import TYPE_CHECKING

from fastapi import APIRouter, Request
from fastapi.responses import RedirectResponse, Response

from sigcat.api.answers.problems import answer_problem, headers_of, problem_from
from sigcat.api.answers.schemas import Problem
from sigcat.api.middleware.registry_access import author_of
from sigcat.api.requests.dependencies import TheSettings, TheWorkQueue
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import InThread, in_thread
from sigcat.api.routes.registry_writing import in_turn
from sigcat.catalogue.hosting.library import Library
from sigcat.errors import SigcatError, UsageError
from sigcat.limits import REGISTRY_REQUEST_SECONDS, Limits
from sigcat.names import either
from sigcat.registry.reference import KIND_OF, Kind, Reference, reference_of
from sigcat.web.forms import EMPTY, Form, form_catalogue
from sigcat.web.pages.registry_pages import Again, name_page, registry_page
from sigcat.web.registry_visits import OwnSite, RegistryVisit, SignedForm, SignedIn, field
from sigcat.web.rendering import page_for

if TYPE_CHECKING:
    from sigcat.registry.candidates.candidate import Candidate

router = APIRouter(route_class=InThread)


@router.get("/registry/publish")
def show_publish(visit: RegistryVisit, _: SignedIn) -> Response:
    """The form for files."""
    return page_for(visit, "registry_publish.html", outcomes=None, problem=None, form=EMPTY)


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
    except SigcatError as error:
        shown = partial(page_for, visit, "registry_publish.html", outcomes=None, form=form)
        return await _refused(
            request, error, lambda problem: in_thread(request, partial(shown, problem.status, problem=problem))
        )
    published = partial(page_for, outcomes=receipt.outcomes, problem=None, form=EMPTY, now=now())
    return await in_thread(request, published, visit, "registry_publish.html")


async def _refused(request: Request, error: SigcatError, show: Callable[[Problem], Awaitable[Response]]) -> Response:
    """Show the page of a form again, with the problem and what was typed. A failure of the service goes to the log."""
    problem = problem_from(error)
    if problem.status >= HTTPStatus.INTERNAL_SERVER_ERROR:
        await answer_problem(request, error)
    shown = await show(problem)
    shown.headers.update(headers_of(error))
    return shown


@router.post("/registry/decide", dependencies=[OwnSite])
async def decide(
    request: Request,
    registry: TheRegistry,
    queue: TheWorkQueue,
    visit: RegistryVisit,
    session: SignedIn,
    form: SignedForm,
) -> Response:
    """Approve or reject the content of a pending version. A refused form keeps its values."""
    from sigcat.registry.decisions.approvals import approve, reject

    author = author_of(session.token, "approve")
    kind, reference = _version(form)
    owner, content = field(form, "owner") or author.owner, field(form, "content")
    written = registry.written_by(author)
    if _chosen(form, "approve", "reject") == "approve":
        change = partial(approve, written, kind, reference, owner, content=content)
    else:
        change = partial(reject, written, kind, reference, owner, form.last("reason"), content)
    try:
        await in_turn(request, change)
    except SigcatError as error:
        return await _refused(
            request, error, lambda problem: queue.run(registry_page, visit, registry, 0, Again(problem, form))
        )
    return RedirectResponse(f"{visit.below}/registry#pending", HTTPStatus.SEE_OTHER)


@router.post("/registry/acknowledge", dependencies=[OwnSite])
async def acknowledge_deprecation(
    request: Request, registry: TheRegistry, visit: RegistryVisit, session: SignedIn, form: SignedForm
) -> Response:
    """Record that an owner knows of a deprecation."""
    from sigcat.registry.decisions.acknowledgements import acknowledge

    author = author_of(session.token, "approve")
    kind, reference = _version(form)
    owner = field(form, "owner") or author.owner
    await in_turn(request, lambda: acknowledge(registry.written_by(author), kind, reference, owner))
    return RedirectResponse(f"{visit.below}/registry#deprecated", HTTPStatus.SEE_OTHER)


@router.post("/registry/end", dependencies=[OwnSite])
async def end_version(
    request: Request,
    registry: TheRegistry,
    queue: TheWorkQueue,
    visit: RegistryVisit,
    session: SignedIn,
    form: SignedForm,
) -> Response:
    """Deprecate or retire a version. A refused form keeps its values."""
    from sigcat.registry.lines import set_state

    author = author_of(session.token, "publish")
    kind, reference = _version(form)
    ended = partial(set_state, registry.written_by(author), kind, reference)
    if _chosen(form, "deprecate", "retire") == "deprecate":
        change = partial(ended, "deprecated", field(form, "until"), field(form, "successor"))
    else:
        change = partial(ended, "retired")
    try:
        await in_turn(request, change)
    except SigcatError as error:
        shown = (visit, registry, f"{kind}s", reference.name, ("", ""), reference.version)
        return await _refused(request, error, lambda problem: queue.run(name_page, *shown, Again(problem, form)))
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


def _version(form: Form) -> tuple[Kind, Reference]:
    kind = KIND_OF.get(field(form, "group"))
    if kind is None:
        raise UsageError(f"The group must be {either(KIND_OF)}, not {field(form, 'group')[:80]!r}.")
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
