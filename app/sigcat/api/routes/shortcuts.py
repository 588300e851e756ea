"""The operation that is asked most, without FastAPI around it: that takes several times as long as its answer.

The operation stays where it is, and describes itself in the OpenAPI document. The shortcut answers plain requests for nodes that
exist and have few children; the operation answers all others, and checks them.
"""

from fastapi import Request
from fastapi.responses import Response
from starlette.types import ASGIApp, Receive, Scope, Send

from sigcat.api.requests.dependencies import library_of, mark_catalogue
from sigcat.api.requests.thread_turns import is_for_the_loop
from sigcat.api.routes.catalogues import node_answer, router

_LONGEST = 200
"""Characters of an address whose parts need no check of their length."""
_CONDITIONS = (b"if-match", b"if-none-match")
_ROUTE = f"{router.prefix}/nodes/{{path}}"
_CATALOGUES = router.prefix.partition("{")[0]


class NodeShortcut:
    """Answers what is plain, and passes on what is not."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or pass the request on."""
        response = _answer(scope) if scope["type"] == "http" and _is_plain(scope) else None
        await (response or self._app)(scope, receive, send)


def _is_plain(scope: Scope) -> bool:
    """Whether nothing is asked but a form of the answer."""
    return (
        scope["method"] == "GET"
        and not scope["query_string"]
        and len(scope["path"]) <= _LONGEST
        and all(name not in _CONDITIONS for name, _ in scope["headers"])
    )


def _answer(scope: Scope) -> Response | None:
    """The node of an address, if a catalogue that is named as it is has it."""
    path: str = scope["path"].removeprefix(scope.get("root_path", ""))
    catalogue, is_node, name = path.removeprefix(_CATALOGUES).partition("/nodes/")
    if not is_node or not path.startswith(_CATALOGUES):
        return None
    request = Request(scope)
    hosted = library_of(request).find(catalogue)
    node = hosted and hosted.catalogue.get(name)
    if hosted is None or node is None or not is_for_the_loop(request, node):
        return None
    mark_catalogue(request, hosted, is_fixed=False)
    scope["state"]["route"] = _ROUTE  # for the log and the metrics
    return node_answer(request, hosted, node)
