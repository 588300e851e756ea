"""Static metadata as clients of VISS read it (COVESA Vehicle Information Service Specification, version 2).

A client is given `…/catalogues/ID/viss` as the address of its server and asks for `/Vehicle/Speed?filter=…`. Values
of signals are not here: they are in a vehicle.
"""

import datetime as dt
import json
from collections.abc import Callable, Coroutine
from http import HTTPStatus
from typing import Annotated, Any

from fastapi import APIRouter, Path, Query, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import JSONResponse, Response
from fastapi.routing import APIRoute

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import caching_headers
from sigcat.api.answers.problems import problem_from
from sigcat.api.answers.serializers import plain, plain_text
from sigcat.api.requests.dependencies import CatalogueOfNode, TheSettings, judge_conditions
from sigcat.api.requests.long_reading import has_more, in_turn
from sigcat.catalogue.model.catalogue import Node
from sigcat.errors import NotFound
from sigcat.limits import DEFAULT_LIMITS, PARAMETER_CHARACTERS


class VissRoute(APIRoute):
    """A route that answers an invalid request in the form of VISS, whatever part of it is invalid."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """Handle a request."""
        handle = super().get_route_handler()

        async def handled(request: Request) -> Response:
            try:
                return await handle(request)
            except NotFound as error:
                return _refusal(HTTPStatus.NOT_FOUND, "invalid_path", str(error))
            except RequestValidationError as error:
                return _refusal(HTTPStatus.BAD_REQUEST, "bad_request", f"{problem_from(error).detail} {_ONLY_METADATA}")

        return handled


router = APIRouter(prefix="/api/v1/catalogues/{catalogue}/viss", tags=["catalogues"], route_class=VissRoute)

_VARIANTS = ("static-metadata", "static_metadata")
_EXAMPLE = '{"type":"static-metadata","parameter":""}'
_ONLY_METADATA = f"Only metadata is here: filter={_EXAMPLE}"


@router.get(
    "/{path:path}",
    response_model=schemas.VissMetadata,
    responses={
        400: {"model": schemas.VissErrorAnswer, "description": "The request asks for something else than metadata"},
        404: {"model": schemas.VissErrorAnswer, "description": "There is no such node, or no such catalogue"},
    },
)
async def get_viss_metadata(
    request: Request,
    hosted: CatalogueOfNode,
    settings: TheSettings,
    path: Annotated[
        str,
        Path(description="Path of a node, with slashes.", examples=["Vehicle/Speed"], max_length=PARAMETER_CHARACTERS),
    ],
    filter: Annotated[  # noqa: A002 - the name that VISS gives it
        str, Query(description="The filter of VISS, as JSON.", examples=[_EXAMPLE], max_length=PARAMETER_CHARACTERS)
    ],
) -> Response:
    """Metadata of a node and of all below it, in the form of VISS."""
    if not _asks_for_metadata(filter):
        return _refusal(HTTPStatus.BAD_REQUEST, "bad_request", _ONLY_METADATA)
    node = hosted.catalogue.get(path.strip("/").replace("/", "."))
    if node is None:
        return _refusal(HTTPStatus.NOT_FOUND, "invalid_path", f"Unknown node {path[:200]!r}.")
    judge_conditions(request)
    if has_more([node], DEFAULT_LIMITS.path_names, settings.tree_nodes):
        message = f"The tree has more than {settings.tree_nodes:,} nodes. Ask for a branch."
        return _refusal(HTTPStatus.BAD_REQUEST, "bad_request", message)
    return await in_turn(request, [node], DEFAULT_LIMITS.path_names, _metadata_answer, request, node)


def _metadata_answer(request: Request, node: Node) -> Response:
    return JSONResponse({"metadata": {node.name: _metadata(node)}, "ts": _now()}, headers=caching_headers(request))


def _asks_for_metadata(text: str) -> bool:
    """Whether a filter, one or a list of them, is the one for metadata. Its kind is `type`, `variant` in later drafts."""
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return False
    filters = value if isinstance(value, list) else [value]
    kinds = [each.get("type", each.get("variant")) for each in filters if isinstance(each, dict)]
    return len(kinds) == 1 and kinds[0] in _VARIANTS


def _metadata(node: Node) -> dict[str, Any]:
    data: dict[str, Any] = plain({name: value for name, value in node.values.items() if value is not None})
    if node.children:
        data["children"] = {plain_text(child.name): _metadata(child) for child in node.children}
    return data


def _refusal(status: HTTPStatus, reason: str, message: str) -> Response:
    error = {"number": str(status.value), "reason": reason, "message": plain_text(message)}
    return JSONResponse({"error": error, "ts": _now()}, status)


def _now() -> str:
    return dt.datetime.now(dt.UTC).strftime("%Y-%m-%dT%H:%M:%SZ")
