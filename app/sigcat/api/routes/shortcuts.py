"""The operations that are asked most, without FastAPI around them: that takes several times as long as their answers.

The operations stay where they are, and describe themselves in the OpenAPI document. The shortcuts answer plain requests: for nodes
that exist and have few children, and for a few words that the catalogue has. The operation answers all others: it checks them, and
runs in a thread what may take long.
"""

import re
from collections.abc import Mapping
from functools import lru_cache

from fastapi import Request
from starlette.types import ASGIApp, Receive, Scope, Send

from sigcat.api.answers import serializers
from sigcat.api.answers.negotiation import ANY, JSON, VARY_OF_304, json_bytes
from sigcat.api.answers.versions import state_of
from sigcat.api.requests.dependencies import headers_of_state
from sigcat.api.requests.thread_turns import has_few_children, has_turn
from sigcat.api.routes.catalogues import SearchQuery, found, router, search_page
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Hosted, Library
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
_NODE, _SEARCH = f"{router.prefix}/nodes/{{path}}", f"{router.prefix}/search"

Headers = tuple[tuple[bytes, bytes], ...]


class Shortcuts:
    """Answers what is plain, and passes on what is not."""

    def __init__(self, app: ASGIApp, library: Library, settings: Settings) -> None:
        self._app = app
        self._library = library
        self._settings = settings

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or pass the request on."""
        body = self._answer(scope) if scope["type"] == "http" and _is_plain(scope) else None
        if body is None:
            await self._app(scope, receive, send)
            return
        caching: Mapping[str, str] = scope["state"]["caching"]
        headers = [*_headers(tuple(caching.items()), may_be_packed=_PACKED in scope["headers"])]
        headers.append((b"content-length", b"%d" % len(body)))
        await send({"type": "http.response.start", "status": 200, "headers": headers})
        await send({"type": "http.response.body", "body": body})

    def _answer(self, scope: Scope) -> bytes | None:
        """Return the answer if the address names a catalogue as it is, and something in it."""
        path: str = scope["path"].removeprefix(scope.get("root_path", ""))
        if not path.startswith(_CATALOGUES):
            return None
        catalogue, _, rest = path.removeprefix(_CATALOGUES).partition("/")
        hosted = self._library.find(catalogue)
        if hosted is None:
            return None
        if rest.startswith("nodes/") and not scope["query_string"]:
            return self._node(scope, hosted, rest.removeprefix("nodes/"))
        words = _WORDS.fullmatch(scope["query_string"]) if rest == "search" else None
        return self._found(scope, hosted, words[1].decode().split("+")) if words else None

    def _node(self, scope: Scope, hosted: Hosted, path: str) -> bytes | None:
        """Return a node that exists and has few children."""
        node = hosted.catalogue.get(path)
        if node is None or not has_few_children(node):
            return None
        self._mark(scope, hosted, _NODE)
        return json_bytes(serializers.node_data(hosted.catalogue, node))

    def _found(self, scope: Scope, hosted: Hosted, words: list[str]) -> bytes | None:
        """Return the hits of a few words that a catalogue has which is not large."""
        catalogue, request = hosted.catalogue, Request(scope)
        query = SearchQuery.model_validate({"q": " ".join(words)})
        is_long = len(query.q) > self._settings.query_characters
        if is_long or len(catalogue.nodes) > _FEW_NODES or not has_index(catalogue):
            return None
        if not all(hosted.search_index.is_known(word.lower()) for word in words) or not has_turn(request):
            return None
        self._mark(scope, hosted, _SEARCH)
        return json_bytes(search_page(request, *found(hosted, self._settings, query)))

    def _mark(self, scope: Scope, hosted: Hosted, route: str) -> None:
        """Keep which catalogue the answer is about, for its headers, and the route, for the log and the metrics."""
        caching = headers_of_state(state_of(hosted), self._settings.reading, is_fixed=False)
        scope["state"].update(hosted=hosted, caching=caching, route=route)


def _is_plain(scope: Scope) -> bool:
    """Whether nothing is asked but an address, as JSON."""
    if scope["method"] != "GET" or len(scope["path"]) > _LONGEST:
        return False
    for name, value in scope["headers"]:
        if name in _CONDITIONS or (name == b"accept" and value not in _AS_JSON):
            return False
    return True


@lru_cache(64)
def _headers(caching: tuple[tuple[str, str], ...], *, may_be_packed: bool) -> Headers:
    """Headers of an answer as the operation has them; `Packing` completes `Vary` of one that it may pack."""
    return (
        *((name.lower().encode(), value.encode()) for name, value in caching),
        (b"vary", b"Accept" if may_be_packed else VARY_OF_304.encode()),
        (b"content-type", JSON.encode()),
    )
