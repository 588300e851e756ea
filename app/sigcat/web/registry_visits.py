"""Readers of pages of the registry, and forms of people who are signed in."""

import re
import secrets
from http import HTTPStatus
from typing import TYPE_CHECKING, Annotated
from urllib.parse import quote

from fastapi import Depends, Request
from starlette.exceptions import HTTPException

from sigcat.api.middleware.registry_access import is_of_own_site, may_read
from sigcat.api.requests.dependencies import PostedBody, TheSettings, TheWorkQueue
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import in_thread
from sigcat.errors import UsageError
from sigcat.limits import NAME_CHARACTERS
from sigcat.web.addresses import Addresses
from sigcat.web.forms import Form, posted_form, read_form
from sigcat.web.visits import Visit, mounted_below, visit_of

if TYPE_CHECKING:
    from sigcat.registry.storing.sessions import Session

COOKIE = "sigcat_session"
FORM = "form"
"""Field of the value that only pages of the session have."""
_PAGE = re.compile(r"/registry(?:/[A-Za-z0-9._~%-]+)*", re.ASCII)
_OTHER_SITE = "A page of another site must not change the registry."
_STALE = "The form must be one of this session. Open the page again, and send it from there."


async def _registry_visit(request: Request, registry: TheRegistry, settings: TheSettings) -> Visit:
    """The visit of a page, by a session or a token. A browser without either is sent to the page to sign in."""
    secret = request.cookies.get(COOKIE, "")
    session = await in_thread(request, _session, registry, secret) if secret else None
    if session is None:
        try:
            await may_read(request, registry, settings)
        except HTTPException as refusal:
            if refusal.status_code != HTTPStatus.UNAUTHORIZED or "authorization" in request.headers:
                raise
            raise _sign_in(request) from None
    return visit_of(request)._replace(session=session)


def _session(registry: HostedRegistry, secret: str) -> "Session | None":
    from sigcat.registry.storing.sessions import find_session

    with registry.reading() as connection:
        return find_session(connection, secret)


def _sign_in(request: Request) -> HTTPException:
    to, path = Addresses(mounted_below(request)), request.scope["path"].removeprefix(mounted_below(request))
    address = to.page("registry", "login") + to.query({"next": quote(path) if request.method == "GET" else ""})
    return HTTPException(HTTPStatus.SEE_OTHER, headers={"Location": address})


RegistryVisit = Annotated[Visit, Depends(_registry_visit)]


async def _signed_in(request: Request, visit: RegistryVisit) -> "Session":
    if visit.session is None:
        raise _sign_in(request)
    return visit.session


SignedIn = Annotated["Session", Depends(_signed_in)]


async def _own_site(request: Request) -> None:
    """Raises 403 for a form that a page of another site sends."""
    if not is_of_own_site(request):
        raise HTTPException(HTTPStatus.FORBIDDEN, _OTHER_SITE)


OwnSite = Depends(_own_site)
"""Evaluated before anything else of a form: another site learns nothing about the session."""


async def _any_form(_: Annotated[None, OwnSite], request: Request, body: PostedBody, queue: TheWorkQueue) -> Form:
    return await queue.run(read_form, posted_form(body, request.headers.get("content-type", "")))


OwnForm = Annotated[Form, Depends(_any_form)]
"""A form that is not of another site."""


async def _signed_form(form: OwnForm, session: SignedIn) -> Form:
    """The form of a page of this session."""
    if not secrets.compare_digest(form.last(FORM).encode(), session.form.encode()):
        raise HTTPException(HTTPStatus.FORBIDDEN, _STALE)
    return form


SignedForm = Annotated[Form, Depends(_signed_form)]


def field(form: Form, name: str) -> str:
    """A field of a line. Raises UsageError if it is too long."""
    text = form.last(name).strip()
    if len(text) > NAME_CHARACTERS:
        raise UsageError(f"The field {name!r} must have at most {NAME_CHARACTERS} characters, not {len(text)}.")
    return text


def page_after(form: Form) -> str:
    """Path of the page to show next, always one of the registry."""
    path = field(form, "next")
    return path if _PAGE.fullmatch(path) and ".." not in path else "/registry"
