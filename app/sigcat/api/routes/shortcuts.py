"""Operations that are asked most, without FastAPI around them: it takes ten times as long as their answers.

The operations stay where they are, and describe themselves in the OpenAPI document. A shortcut takes the plain requests for one of
them, those without a query; any other goes on to the operation, which checks what it has to.
"""

from fastapi import Request
from fastapi.responses import Response
from starlette.routing import Match, Route
from starlette.types import Scope

from sigcat.api.requests.dependencies import hosted_catalogue
from sigcat.api.routes.catalogues import node_answer, router

_LONGEST = 200
"""Characters of an address whose parts need no check of their length."""


class Shortcut(Route):
    """A way around the dependencies of an operation."""

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        """Whether it is a plain request for the operation."""
        if scope["method"] != "GET" or scope["query_string"] or len(scope["path"]) > _LONGEST:
            return Match.NONE, {}
        match, found = super().matches(scope)
        return match, {**found, "route": self}  # as FastAPI says it: the log and the metrics name the route


async def _get_node(request: Request) -> Response:
    hosted = await hosted_catalogue(request.path_params["catalogue"], request)
    return node_answer(request, hosted, request.path_params["path"])


SHORTCUTS = (Shortcut(f"{router.prefix}/nodes/{{path}}", _get_node),)
