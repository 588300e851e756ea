"""Access to the registry: who may write, and refusals of pages of other sites."""

import ipaddress
import re
from http import HTTPStatus
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

from fastapi import Depends, Request
from starlette.exceptions import HTTPException

from sigcat.api.middleware.access import check_scope
from sigcat.api.requests.dependencies import TheSettings
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import in_thread
from sigcat.api.settings import Settings
from sigcat.api.tokens import bearer

if TYPE_CHECKING:
    from sigcat.registry.author import Author
    from sigcat.registry.storing.ledger import Registry
    from sigcat.registry.storing.tokens import Scope, Token

_PROXIES = ("forwarded", "via", "x-forwarded-for", "x-forwarded-host", "x-real-ip")
"""Headers that only a proxy sends: the address of the client is then that of the proxy."""
_PORT = re.compile(r":[0-9]+\Z")
_CHALLENGE = {"WWW-Authenticate": 'Bearer realm="sigcat"'}


async def may_read(request: Request, registry: TheRegistry, settings: TheSettings) -> None:
    """A dependency: where reading needs a token, one of the service with the scope `read`, or any of the registry."""
    authorization = request.headers.get("authorization", "")
    if settings.reading == "token" and bearer(authorization, settings.tokens) is None:
        await in_thread(request, _author, authorization, registry, "read", needs_token=True)
    elif settings.reading == "token":
        check_scope(authorization, "read", settings.tokens)


class Writer(NamedTuple):
    """A request that may change the registry, and who makes it."""

    request: Request
    registry: HostedRegistry
    author: "Author"

    @property
    def written(self) -> "Registry":
        """The registry to write to. Raises RegistryUnusable."""
        return self.registry.written_by(self.author)


def writer_with(scope: "Scope") -> Any:
    """A dependency that lets only requests through that may write with a scope, and returns who writes."""

    async def writer(request: Request, registry: TheRegistry, settings: TheSettings) -> Writer:
        _refuse_other_sites(request, settings)
        authorization = request.headers.get("authorization", "")
        needs_token = not _is_local(request, settings)
        author = await in_thread(request, _author, authorization, registry, scope, needs_token=needs_token)
        return Writer(request, registry, author)

    return Depends(writer)


Publisher = Annotated[Writer, writer_with("publish")]
Approver = Annotated[Writer, writer_with("approve")]
Administrator = Annotated[Writer, writer_with("administer")]
Reader = Depends(may_read)


def _author(authorization: str, registry: HostedRegistry, scope: "Scope", *, needs_token: bool) -> "Author":
    """The author of a request. Raises 401 without a valid token, 403 without the scope.

    A token is needed once there is one: a revoked one does not open what it closed.
    """
    from sigcat.registry.author import ANYONE
    from sigcat.registry.storing.tokens import all_tokens, find_token

    kind, _, secret = authorization.partition(" ")
    with registry.reading() as connection:
        token = find_token(connection, secret.strip()) if kind.lower() == "bearer" else None
        if not (authorization or needs_token or all_tokens(connection)):
            return ANYONE
    if token is None or token.fault:
        raise HTTPException(HTTPStatus.UNAUTHORIZED, _refusal(token, scope, authorization), headers=_CHALLENGE)
    return author_of(token, scope)


def author_of(token: "Token", scope: "Scope") -> "Author":
    """Return the writer with a valid token. Raises 403 without the scope."""
    from sigcat.registry.author import Author

    if not token.has(scope):
        raise HTTPException(HTTPStatus.FORBIDDEN, f"The token {token.name!r} must have the scope {scope!r}.")
    return Author(token.name, token.owner)


def _refusal(token: "Token | None", scope: "Scope", authorization: str) -> str:
    if token is not None:
        return f"The token {token.name!r} is {token.fault}. Ask the administrator of the registry for another one."
    if authorization:
        return (
            "The token of the request is not one of this registry. `sigcat registry token list` lists their names, where"
            " the database is."
        )
    return (
        f"The request must have a token of the registry with the scope {scope!r}. Send the header `Authorization: Bearer "
        f"TOKEN`; `sigcat registry token create NAME --scope {scope}` makes one."
    )


def _refuse_other_sites(request: Request, settings: Settings) -> None:
    """Raises 403 for a request that a page of another origin makes, unless `origins` has it."""
    has_token = "*" in settings.origins and "authorization" in request.headers
    if is_of_own_site(request) or request.headers.get("origin") in settings.origins or has_token:
        return
    detail = "A page of another site must not change the registry. Add its origin to `origins` of [service] if it may."
    raise HTTPException(HTTPStatus.FORBIDDEN, detail)


def is_of_own_site(request: Request) -> bool:
    """Whether a page of the service makes a request, or a program that is not a browser."""
    origin, site = request.headers.get("origin"), request.headers.get("sec-fetch-site", "none")
    is_own = origin is None or origin.partition("//")[2] == request.state.host
    return is_own and site in ("none", "same-origin")


def _is_local(request: Request, settings: Settings) -> bool:
    """Whether the request comes from this machine, and by no proxy. The header `Host` is that of no other name (rebinding)."""
    names = (settings.host, request.client.host if request.client else "", _PORT.sub("", request.state.host))
    is_proxied = settings.trusted_proxies or any(name in request.headers for name in _PROXIES)
    return not is_proxied and all(map(_is_loopback, names))


def _is_loopback(host: str) -> bool:
    try:
        return host == "localhost" or ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False
