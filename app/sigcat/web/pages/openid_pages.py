"""Sign in to the registry by OpenID Connect."""

import secrets
from http import HTTPStatus
from typing import Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import RedirectResponse, Response
from starlette.exceptions import HTTPException

from sigcat.api.requests.dependencies import TheSettings, TheWorkQueue
from sigcat.api.requests.hosted_registry import TheRegistry
from sigcat.api.requests.thread_turns import in_thread
from sigcat.api.settings import Settings
from sigcat.errors import NotFound, UsageError
from sigcat.limits import PARAMETER_CHARACTERS
from sigcat.web.openid import Begun, ProviderFailed, begin, person_of
from sigcat.web.pages.registry_login import begin_in_turn, with_session
from sigcat.web.rendering import page
from sigcat.web.visits import mounted_below

router = APIRouter()
_COOKIE = "sigcat_openid"
_SECONDS = 600
"""Seconds that a person may take at the provider."""
_NOT_BEGUN = "The sign-in must begin in this browser, at most 10 minutes before. Sign in again."
Text = Annotated[str, Query(max_length=PARAMETER_CHARACTERS)]


@router.get("/registry/openid")
async def begin_openid(request: Request, _: TheRegistry, settings: TheSettings, queue: TheWorkQueue) -> Response:
    """Send the browser to the provider, with random values in a cookie that it returns with."""
    _refuse_without(settings)
    try:
        begun, address = await queue.run_here(begin, settings)
    except ProviderFailed as failure:
        raise HTTPException(HTTPStatus.SERVICE_UNAVAILABLE, str(failure)) from None
    answer = RedirectResponse(address, HTTPStatus.SEE_OTHER)
    answer.set_cookie(
        _COOKIE, ".".join(begun), _SECONDS, path=_path(request), secure=request.scope["scheme"] == "https", httponly=True,
        samesite="lax",  # the provider's page leads back
    )  # fmt: skip
    return answer


@router.get("/registry/openid/return")
async def end_openid(
    request: Request,
    registry: TheRegistry,
    settings: TheSettings,
    queue: TheWorkQueue,
    code: Text = "",
    state: Text = "",
    iss: Text = "",
    error: Text = "",
) -> Response:
    """Begin a session of the person whom the provider vouches for.

    The page leads on by itself: a browser sends the cookie of the session only from a page of the service.
    """
    _refuse_without(settings)
    begun = _begun(request, state)
    if error or not code or iss not in ("", settings.openid_issuer):
        raise HTTPException(
            HTTPStatus.FORBIDDEN, f"The provider of OpenID Connect did not sign you in: {error or 'no code'}."
        )
    try:
        person = await queue.run_here(person_of, settings, code, begun)
    except (ProviderFailed, UsageError) as failure:
        raise HTTPException(HTTPStatus.FORBIDDEN, str(failure)) from None
    secret = await begin_in_turn(request, registry, person)
    answer = await in_thread(request, page, request, "registry_signed_in.html", person=person)
    answer.delete_cookie(_COOKIE, path=_path(request), httponly=True, samesite="lax")
    return with_session(request, answer, secret)


def _refuse_without(settings: Settings) -> None:
    if not settings.openid_issuer:
        raise NotFound("The service has no provider of OpenID Connect. Set `openid_issuer` in [service].")


def _begun(request: Request, state: str) -> Begun:
    """The values of the sign-in that this browser has begun. Raises 403."""
    values = request.cookies.get(_COOKIE, "").split(".")
    begun = Begun(*values) if len(values) == len(Begun._fields) and all(values) else None
    if begun is None or not secrets.compare_digest(begun.state.encode(), state.encode()):
        raise HTTPException(HTTPStatus.FORBIDDEN, _NOT_BEGUN)
    return begun


def _path(request: Request) -> str:
    return f"{mounted_below(request)}/registry/openid"
