"""Who may do what: a bearer token with the scope that an operation needs."""

from collections.abc import Iterable
from http import HTTPStatus
from typing import Any

from fastapi import Request, Security
from fastapi.security import HTTPBearer
from starlette.exceptions import HTTPException

from sigcat.api.requests.dependencies import TheSettings
from sigcat.api.tokens import Scope, Token, token_named

_BEARER = HTTPBearer(
    scheme_name="token",
    auto_error=False,
    description="`Authorization: Bearer TOKEN`; `sigcat config --new-token` makes one.",
)


def needs(scope: Scope) -> Any:
    """A dependency that lets only tokens with a scope through."""

    async def check(request: Request, settings: TheSettings) -> None:
        check_scope(request.headers.get("authorization", ""), scope, settings.tokens)

    check.__name__ = f"needs_{scope}"
    return (Security(_BEARER), Security(check))


def check_scope(authorization: str, scope: Scope, tokens: Iterable[Token]) -> Token:
    """The token of a request. Raises 401 without a valid one, 403 without the scope."""
    kind, _, secret = authorization.partition(" ")
    token = token_named(secret.strip(), tokens) if kind.lower() == "bearer" else None
    if token is None:
        detail = f"This needs a token with the scope {scope!r}: Authorization: Bearer TOKEN."
        raise HTTPException(HTTPStatus.UNAUTHORIZED, detail, headers={"WWW-Authenticate": 'Bearer realm="sigcat"'})
    if scope not in token.scopes:
        detail = f"The token {token.name!r} has no scope {scope!r}."
        raise HTTPException(HTTPStatus.FORBIDDEN, detail)
    return token
