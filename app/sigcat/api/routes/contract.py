"""The OpenAPI document, and what the service as a whole understands."""

from typing import Any

from fastapi import APIRouter, Request
from fastapi.responses import Response
from starlette.routing import BaseRoute, Match
from starlette.types import Receive, Scope, Send

from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.requests.thread_turns import InThread

router = APIRouter(route_class=InThread)


@router.get("/openapi.json", include_in_schema=False)
def get_openapi_document(request: Request) -> Response:
    """The OpenAPI document; below a path, with the address of the service there."""
    document: dict[str, Any] = request.app.openapi()
    below = request.scope.get("root_path", "").rstrip("/")
    servers = [{"url": below}] if below else []
    return Response(json_bytes({**document, "servers": [*servers, *document["servers"]]}), media_type=JSON)


class WholeService(BaseRoute):
    """`OPTIONS *` asks what the server understands, whatever the address (RFC 9110, 9.3.7)."""

    path = "*"

    def matches(self, scope: Scope) -> tuple[Match, Scope]:
        """Whether it is asked; connections let `*` through with no other method."""
        is_asked = scope["type"] == "http" and scope["path"].removeprefix(scope.get("root_path", "")) == self.path
        return (Match.FULL, {"route": self}) if is_asked else (Match.NONE, {})

    async def handle(self, scope: Scope, receive: Receive, send: Send) -> None:
        """The methods."""
        answer = Response(status_code=204, headers={"Allow": "GET, HEAD, OPTIONS, POST"})
        await answer(scope, receive, send)


WHOLE_SERVICE = WholeService()
