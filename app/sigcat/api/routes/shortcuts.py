"""The operations that are asked most, without FastAPI around them: that takes several times as long as their answers.

The operations stay where they are, and describe themselves in the OpenAPI document. The shortcuts answer plain requests: for nodes
that exist and have few children, and for a few words that the catalogue has. The operation answers all others: it checks them, and
runs in a thread what may take long.
"""

import re

from fastapi import Request
from starlette.types import ASGIApp, Receive, Scope, Send

from sigcat.api.answers.negotiation import ANY, JSON, VARY_OF_304, json_bytes
from sigcat.api.answers.serializers import node_data
from sigcat.api.requests.dependencies import library_of, mark_catalogue, settings_of
from sigcat.api.requests.thread_turns import has_few_children, has_turn
from sigcat.api.routes.catalogues import SearchQuery, found, router, search_page
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.search import has_index

_LONGEST = 200
"""Characters of an address whose parts need no check of their length."""
_FEW_NODES = 20_000
"""Nodes among which a search for a few words takes a millisecond."""
_WORDS = re.compile(rb"q=([A-Za-z]{3,40}(?:\+[A-Za-z]{3,40}){0,3})")
"""A query of a few words and nothing else."""
_CONDITIONS = (b"if-match", b"if-none-match")
_AS_JSON = (ANY.encode(), JSON.encode())
_PACKED = (b"accept-encoding", b"gzip")
"""As `RequestHeaders` says it."""
_CATALOGUES = router.prefix.partition("{")[0]


class Shortcuts:
    """Answers what is plain, and passes on what is not."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or pass the request on."""
        body = _answer(scope) if scope["type"] == "http" and _is_plain(scope) else None
        if body is None:
            await self._app(scope, receive, send)
            return
        await send({"type": "http.response.start", "status": 200, "headers": _headers(scope, len(body))})
        await send({"type": "http.response.body", "body": body})


def _is_plain(scope: Scope) -> bool:
    """Whether nothing is asked but an address, as JSON."""
    if scope["method"] != "GET" or len(scope["path"]) > _LONGEST:
        return False
    for name, value in scope["headers"]:
        if name in _CONDITIONS or (name == b"accept" and value not in _AS_JSON):
            return False
    return True


def _answer(scope: Scope) -> bytes | None:
    """What is answered, if the address names a catalogue as it is, and something in it."""
    path: str = scope["path"].removeprefix(scope.get("root_path", ""))
    if not path.startswith(_CATALOGUES):
        return None
    catalogue, _, rest = path.removeprefix(_CATALOGUES).partition("/")
    request = Request(scope)
    hosted = library_of(request).find(catalogue)
    if hosted is None:
        return None
    if rest.startswith("nodes/") and not scope["query_string"]:
        return _node(request, hosted, rest.removeprefix("nodes/"))
    words = _WORDS.fullmatch(scope["query_string"]) if rest == "search" else None
    return _found(request, hosted, words[1].decode().split("+")) if words else None


def _node(request: Request, hosted: Hosted, path: str) -> bytes | None:
    """A node that exists and has few children."""
    node = hosted.catalogue.get(path)
    if node is None or not has_few_children(node):
        return None
    _mark(request, hosted, "/nodes/{path}")
    return json_bytes(node_data(hosted.catalogue, node))


def _found(request: Request, hosted: Hosted, words: list[str]) -> bytes | None:
    """What a few words find that a catalogue has which is not large."""
    catalogue, settings = hosted.catalogue, settings_of(request)
    query = SearchQuery.model_validate({"q": " ".join(words)})
    if len(catalogue.nodes) > _FEW_NODES or not has_index(catalogue) or len(query.q) > settings.query_characters:
        return None
    if not all(hosted.search_index.is_known(word.lower()) for word in words) or not has_turn(request):
        return None
    _mark(request, hosted, "/search")
    return json_bytes(search_page(request, *found(hosted, settings, query)))


def _mark(request: Request, hosted: Hosted, route: str) -> None:
    """Keep which catalogue the answer is about, for its headers, and the route, for the log and the metrics."""
    mark_catalogue(request, hosted, is_fixed=False)
    request.scope["state"]["route"] = f"{router.prefix}{route}"


def _headers(scope: Scope, length: int) -> list[tuple[bytes, bytes]]:
    """Headers of an answer as the operation has them; `Packing` completes `Vary` of one that it may pack."""
    caching: dict[str, str] = scope["state"]["caching"]
    return [
        *((name.lower().encode(), value.encode()) for name, value in caching.items()),
        (b"vary", b"Accept" if _PACKED in scope["headers"] else VARY_OF_304.encode()),
        (b"content-length", b"%d" % length),
        (b"content-type", JSON.encode()),
    ]
