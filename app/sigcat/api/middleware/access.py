"""Access: a bearer token with the scope that an operation needs."""

from collections.abc import Iterable
from http import HTTPStatus
from typing import Any

from fastapi import Request, Security
from fastapi.security import HTTPBearer
from starlette.exceptions import HTTPException
from starlette.types import ASGIApp, Receive, Send
from starlette.types import Scope as Connection

from sigcat.api.answers.problems import answer_problem
from sigcat.api.requests.dependencies import TheSettings
from sigcat.api.settings import Settings
from sigcat.api.tokens import Scope, Token, bearer

_BEARER = HTTPBearer(
    scheme_name="token",
    auto_error=False,
    description="`Authorization: Bearer TOKEN`; `sigcat config --new-token` makes one; for the registry, `sigcat registry token create`.",
)


_ALWAYS_OPEN = ("/health/", "/problems/", "/static/", "/api/v1/registry", "/registry")
_HEALTH = ("/health", "/healthz")


class ReadAccess:
    """Asks every request for a token with the scope `read`, where the operator closed reading."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app = app
        self._settings = settings

    async def __call__(self, scope: Connection, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] == "http" and not _is_open(scope):
            request = Request(scope)
            try:
                check_scope(request.headers.get("authorization", ""), "read", self._settings.tokens)
            except HTTPException as refusal:
                response = await answer_problem(request, refusal)
                await response(scope, receive, send)
                return
        await self._app(scope, receive, send)


def _is_open(scope: Connection) -> bool:
    """Health, explanations of problems and their style need no token; nor does a browser's question before CORS.

    The registry has its own tokens: its API and its pages ask for them.
    """
    path: str = scope["path"].removeprefix(scope.get("root_path", ""))
    return path in _HEALTH or path.startswith(_ALWAYS_OPEN) or scope["method"] == "OPTIONS"


def needs(scope: Scope) -> Any:
    """A dependency that lets only tokens with a scope through."""

    async def check(request: Request, settings: TheSettings) -> None:
        check_scope(request.headers.get("authorization", ""), scope, settings.tokens)

    check.__name__ = f"needs_{scope}"
    return (Security(_BEARER), Security(check))


def check_scope(authorization: str, scope: Scope, tokens: Iterable[Token]) -> Token:
    """The token of a request. Raises 401 without a valid one, 403 without the scope."""
    token = bearer(authorization, tokens)
    if token is None:
        detail = (
            f"The request must have a token with the scope {scope!r}. Send the header `Authorization: Bearer TOKEN`."
        )
        raise HTTPException(HTTPStatus.UNAUTHORIZED, detail, headers={"WWW-Authenticate": 'Bearer realm="sigcat"'})
    if scope not in token.scopes:
        detail = f"The token {token.name!r} must have the scope {scope!r}."
        raise HTTPException(HTTPStatus.FORBIDDEN, detail)
    return token
