"""Two nodes side by side, and the history of a node over releases."""

from http import HTTPStatus
from typing import Annotated, Literal

from fastapi import APIRouter, Depends, Query, Request
from fastapi.responses import Response

from sigcat.api.requests.dependencies import (
    AnyCatalogue,
    NamedCatalogue,
    TheWorkQueue,
    catalogue_at,
    functions_of,
    library_of,
    queue_of,
)
from sigcat.api.requests.thread_turns import in_thread
from sigcat.api.routes.catalogues import find_node, node_at
from sigcat.api.routes.changes import hosted_history
from sigcat.catalogue.hosting.library import Hosted
from sigcat.errors import NotFound
from sigcat.function.node_uses import uses_in
from sigcat.limits import NAME_CHARACTERS, PARAMETER_CHARACTERS
from sigcat.web.rendering import page, page_for
from sigcat.web.views.history_view import history_view
from sigcat.web.views.node_comparison import Side, compare_nodes, same_name_elsewhere, same_path_elsewhere
from sigcat.web.views.node_view import field_units_of
from sigcat.web.visits import Visit, visit_of

router = APIRouter()
Path = Annotated[str, Query(max_length=PARAMETER_CHARACTERS)]


async def _other(
    request: Request,
    hosted: NamedCatalogue,
    other: Annotated[str, Query(max_length=NAME_CHARACTERS, description="Id of the catalogue on the right.")] = "",
) -> Hosted:
    """The catalogue on the right; without a name, that on the left."""
    return (await catalogue_at(other, library_of(request), queue_of(request)))[0] if other else hosted


@router.get("/compare")
async def show_comparison(
    request: Request,
    hosted: NamedCatalogue,
    other: Annotated[Hosted, Depends(_other)],
    path: Path = "",
    second: Annotated[str, Query(alias="with", max_length=PARAMETER_CHARACTERS)] = "",
    only: Literal["", "differences"] = "",
) -> Response:
    """Two nodes of one or two catalogues, attribute by attribute."""
    return await in_thread(request, _comparison, request, hosted, other, path, second, only)


@router.get("/history/{catalogue}/{path}")
async def show_history(request: Request, hosted: AnyCatalogue, path: str, queue: TheWorkQueue) -> Response:
    """Changes of a node in the hosted releases."""
    await node_at(request, hosted.catalogue, path)
    return await queue.run(_history, visit_of(request), hosted, path)


def _history(visit: Visit, hosted: Hosted, path: str) -> Response:
    history = hosted_history(path, hosted.catalogue, visit.library)
    return page_for(visit, "history.html", hosted=hosted, path=path, **history_view(history, visit.library)._asdict())


def _comparison(request: Request, hosted: Hosted, other: Hosted, path: str, second: str, only: str) -> Response:
    roots = hosted.catalogue.roots
    left = _side(request, hosted, path or (roots[0].path if roots else ""))
    is_elsewhere = other.source.id != hosted.source.id
    right = _side(request, other, second or (left.path if is_elsewhere else ""))
    is_whole = left.node is not None and right.node is not None
    is_asked = bool(left.path and right.path)
    return page(
        request,
        "compare.html",
        HTTPStatus.OK if is_whole or not is_asked else HTTPStatus.NOT_FOUND,
        hosted=hosted,
        left=left,
        right=right,
        only=only,
        compared=compare_nodes(left, right) if is_whole else None,
        elsewhere=tuple(same_path_elsewhere(library_of(request), left)),
        alike=same_name_elsewhere(hosted.catalogue, left.node) if left.node else (),
        field_units=field_units_of(request.app.state.rules.rules),
    )


def _side(request: Request, hosted: Hosted, path: str) -> Side:
    if not path:
        return Side(hosted, "")
    try:
        node = find_node(hosted.catalogue, path)
    except NotFound as error:
        return Side(hosted, path, near=tuple(error.nearest))
    uses = uses_in(functions_of(request).files, hosted.catalogue).of_node.get(path, ())
    return Side(hosted, path, node, uses=uses)
