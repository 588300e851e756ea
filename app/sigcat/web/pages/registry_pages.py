"""The registry in the browser: names, their versions, users of a signal, and what may be deployed where."""

from http import HTTPStatus
from typing import Annotated, Literal, NamedTuple

from fastapi import APIRouter, Query
from fastapi.responses import Response

from sigcat.api.answers.schemas import Problem
from sigcat.api.requests.dependencies import NamedCatalogue, TheWorkQueue
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.limits import NAME_CHARACTERS, PARAMETER_CHARACTERS
from sigcat.web.forms import EMPTY, Form
from sigcat.web.registry_visits import RegistryVisit
from sigcat.web.rendering import page_for
from sigcat.web.visits import Visit

router = APIRouter()
VIEWS = "sigcat.web.views.registry_view"
"""Module that loads SQLAlchemy: workers have it only where there is a registry."""
Start = Annotated[int, Query(alias="from", ge=0)]
Version = Annotated[str, Query(max_length=NAME_CHARACTERS)]


class Again(NamedTuple):
    """A page whose form is shown again: why it was refused, and what was typed."""

    problem: Problem | None = None
    form: Form = EMPTY

    @property
    def status(self) -> int:
        """Status of the page."""
        return self.problem.status if self.problem else HTTPStatus.OK


_FIRST = Again()


@router.get("/registry")
async def show_registry(visit: RegistryVisit, registry: TheRegistry, queue: TheWorkQueue, start: Start = 0) -> Response:
    """Published names, and the last entries of the log."""
    return await queue.run(registry_page, visit, registry, start)


@router.get("/registry/lines")
async def show_lines(visit: RegistryVisit, registry: TheRegistry, queue: TheWorkQueue, start: Start = 0) -> Response:
    """Functions and vehicle lines: what runs there, and whether the newest version may be deployed."""
    return await queue.run(_lines, visit, registry, start)


@router.get("/registry/users")
async def show_users(
    visit: RegistryVisit,
    registry: TheRegistry,
    queue: TheWorkQueue,
    hosted: NamedCatalogue,
    path: Annotated[str, Query(max_length=PARAMETER_CHARACTERS)] = "",
) -> Response:
    """Users of a path, with a picture."""
    return await queue.run(_users, visit, registry, hosted.catalogue, path)


@router.get("/registry/deliveries")
async def show_deliveries(
    visit: RegistryVisit, registry: TheRegistry, queue: TheWorkQueue, state: Literal["", "failed"] = ""
) -> Response:
    """The newest events that were sent to webhooks, and the answers."""
    return await queue.run(_deliveries, visit, registry, state)


@router.get("/registry/{group}/{name}")
async def show_name(
    visit: RegistryVisit,
    registry: TheRegistry,
    queue: TheWorkQueue,
    group: str,
    name: str,
    old: Version = "",
    new: Version = "",
    end: Version = "",
) -> Response:
    """The versions of a name, the changes between two of them, and the form that ends one."""
    return await queue.run(name_page, visit, registry, group, name, (old, new), end)


def registry_page(visit: Visit, registry: HostedRegistry, start: int, again: Again = _FIRST) -> Response:
    """The page of published names."""
    from sigcat.web.views.registry_view import registry_view

    with registry.reading() as connection:
        return page_for(visit, "registry.html", again.status, view=registry_view(connection, start), again=again)


def _lines(visit: Visit, registry: HostedRegistry, start: int) -> Response:
    from sigcat.web.views.registry_view import matrix_view

    with registry.reading() as connection:
        return page_for(visit, "registry_lines.html", view=matrix_view(connection, start))


def _users(visit: Visit, registry: HostedRegistry, catalogue: Catalogue, path: str) -> Response:
    from sigcat.registry.users import users_in
    from sigcat.web.pictures.signal_users import user_picture

    with registry.reading() as connection:
        try:
            found = users_in(connection, path, expanded_of(catalogue)) if path else None
        except InputRefused as refused:
            return page_for(
                visit, "registry_users.html", sought=path, found=None, unknown=refused.findings[0], picture=None
            )
    picture = user_picture(path, found.users) if found else None
    return page_for(visit, "registry_users.html", sought=path, found=found, unknown=None, picture=picture)


def _deliveries(visit: Visit, registry: HostedRegistry, state: str) -> Response:
    from sigcat.web.views.registry_view import deliveries_view

    with registry.reading() as connection:
        view = deliveries_view(connection, state)
    return page_for(visit, "registry_deliveries.html", view=view, state=state)


def name_page(
    visit: Visit,
    registry: HostedRegistry,
    group: str,
    name: str,
    compared: tuple[str, str],
    end: str,
    again: Again = _FIRST,
) -> Response:
    """The page of the versions of a name."""
    from sigcat.web.views.registry_view import name_view

    with registry.reading() as connection:
        view = name_view(connection, group, name, *compared)
        return page_for(
            visit, "registry_name.html", again.status, group=group, name=name, view=view, end=end, again=again
        )
