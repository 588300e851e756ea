"""A request for a page as a value: the page can then be made in another process."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

from fastapi import Request

from sigcat.api.requests.dependencies import library_of, settings_of
from sigcat.api.requests.query_parameters import refuse_unless_known
from sigcat.api.tokens import bearer
from sigcat.catalogue.hosting.library import Library
from sigcat.web.basket import PICK, Basket, read_basket

if TYPE_CHECKING:
    from sigcat.registry.storing.sessions import Session

_PART = "part"
"""Parameter that every page takes, besides the basket."""


class Visit(NamedTuple):
    """Facts of a page about its request and the service."""

    library: Library
    method: str
    path: str
    below: str
    """The path below which the whole service is offered."""
    route: str
    """Template of the path; empty if there is no such page."""
    names: Mapping[str, Any]
    """Values of the names in the path."""
    query: tuple[tuple[str, str], ...]
    has_registry: bool
    """Whether the service hosts a registry."""
    may_read_catalogues: bool
    """Whether the page may name the catalogues: pages that need no token, or one of the registry, may not where reading needs one."""
    session: "Session | None" = None
    """The person who is signed in, on pages of the registry."""

    @property
    def wants_part(self) -> bool:
        """Whether only the part of the page is asked for that changes while one stays on it."""
        return any(name == _PART for name, _ in self.query)

    @property
    def basket(self) -> Basket:
        """The chosen paths."""
        return read_basket(",".join(value for name, value in self.query if name == PICK))


async def refuse_unknown(request: Request) -> None:
    """A dependency of every page: raises RequestValidationError for parameters that it does not have."""
    refuse_unless_known(request, (_PART, PICK))


def visit_of(request: Request) -> Visit:
    """The request as a value."""
    return Visit(
        library_of(request),
        request.method,
        request.scope["path"],
        mounted_below(request),
        getattr(request.scope.get("route"), "path", ""),
        request.path_params,
        tuple(request.query_params.multi_items()),
        request.app.state.registry is not None,
        _may_read_catalogues(request),
    )


def _may_read_catalogues(request: Request) -> bool:
    settings = settings_of(request)
    token = bearer(request.headers.get("authorization", ""), settings.tokens)
    return settings.reading == "open" or (token is not None and "read" in token.scopes)


def mounted_below(request: Request) -> str:
    """The path below which the whole service is offered; below a mounted folder, Starlette keeps it apart."""
    scope = request.scope
    return str(scope.get("app_root_path", scope.get("root_path", "")))
