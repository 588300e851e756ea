"""Sign in to the registry with a token, and sign out."""

from http import HTTPStatus
from typing import TYPE_CHECKING, Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import RedirectResponse, Response

from sigcat.api.requests.dependencies import TheSettings
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import InThread, in_thread
from sigcat.api.routes.registry_writing import in_turn
from sigcat.limits import NAME_CHARACTERS, REGISTRY_REQUEST_SECONDS, SESSION_SECONDS
from sigcat.web.registry_visits import COOKIE, OwnForm, OwnSite, SignedForm, field, page_after
from sigcat.web.rendering import page
from sigcat.web.visits import mounted_below

if TYPE_CHECKING:
    from sigcat.registry.storing.tokens import Token

router = APIRouter(route_class=InThread)
_UNKNOWN = "The token must be one of this registry. `sigcat registry token list` lists them."


@router.get("/registry/login")
def show_login(
    request: Request,
    _: TheRegistry,
    settings: TheSettings,
    after: Annotated[str, Query(alias="next", max_length=NAME_CHARACTERS)] = "",
) -> Response:
    """The form for a token."""
    return page(request, "registry_login.html", after=after, refusal="", has_openid=bool(settings.openid_issuer))


@router.post("/registry/login", dependencies=[OwnSite])
async def log_in(request: Request, registry: TheRegistry, settings: TheSettings, form: OwnForm) -> Response:
    """Begin a session of a token, whose secret is in a cookie that no script reads."""
    token = await in_thread(request, _token, registry, field(form, "token"))
    if token is None or token.fault:
        refusal = f"The token {token.name!r} is {token.fault}." if token else _UNKNOWN
        return await in_thread(
            request,
            page,
            request,
            "registry_login.html",
            HTTPStatus.FORBIDDEN,
            after=field(form, "next"),
            refusal=refusal,
            has_openid=bool(settings.openid_issuer),
        )
    secret = await begin_in_turn(request, registry, token)
    answer = RedirectResponse(mounted_below(request) + page_after(form), HTTPStatus.SEE_OTHER)
    return with_session(request, answer, secret)


async def begin_in_turn(request: Request, registry: HostedRegistry, token: "Token") -> str:
    """Begin a session, and return the secret of its cookie."""
    return await in_turn(request, lambda: _begin(registry, token))


def with_session(request: Request, answer: Response, secret: str) -> Response:
    """An answer with the cookie of a session."""
    path, is_secure = mounted_below(request) or "/", request.scope["scheme"] == "https"
    answer.set_cookie(COOKIE, secret, SESSION_SECONDS, path=path, secure=is_secure, httponly=True, samesite="strict")
    return answer


@router.post("/registry/logout", dependencies=[OwnSite])
async def log_out(request: Request, registry: TheRegistry, _: SignedForm) -> Response:
    """End the session."""
    await in_turn(request, lambda: _end(registry, request.cookies[COOKIE]))
    below = mounted_below(request)
    answer = RedirectResponse(f"{below}/registry", HTTPStatus.SEE_OTHER)
    answer.delete_cookie(COOKIE, path=below or "/", httponly=True, samesite="strict")
    return answer


def _token(registry: HostedRegistry, secret: str) -> "Token | None":
    from sigcat.registry.storing.tokens import find_token

    with registry.reading() as connection:
        return find_token(connection, secret)


def _begin(registry: HostedRegistry, token: "Token") -> str:
    from sigcat.registry.storing.database import writing
    from sigcat.registry.storing.sessions import begin_session

    with writing(registry.present(), REGISTRY_REQUEST_SECONDS) as connection:
        return begin_session(connection, token)


def _end(registry: HostedRegistry, secret: str) -> None:
    from sigcat.registry.storing.database import writing
    from sigcat.registry.storing.sessions import end_session

    with writing(registry.present(), REGISTRY_REQUEST_SECONDS) as connection:
        end_session(connection, secret)
