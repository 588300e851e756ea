"""Answers about a catalogue that are cached, so that the same question costs no more than sending them again.

An answer belongs to the state of the catalogue that it was made from; with another state it is forgotten.
"""

from collections import OrderedDict
from typing import NamedTuple

from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sigcat.api.answers.negotiation import VARY_OF_304, liked_types
from sigcat.api.requests.preconditions import is_known
from sigcat.catalogue.hosting.library import Hosted, Library

_LARGEST = 256 * 1024
_WANTED = b"if-match"
"""Judged by the operation: it is rare."""
_ASKED = (b"accept", b"accept-encoding", b"if-none-match", _WANTED)
_SENT_WITH_304 = (b"etag", b"cache-control")

Key = tuple[str, bytes, tuple[str, ...], bytes]
"""Path and query; the forms that the client allows, the best first; how the answer may be packed (`RequestHeaders`)."""


class CachedAnswer(NamedTuple):
    """An answer, and what it was made from."""

    hosted: Hosted
    etag: str
    route: str
    start: Message
    body: Message
    size: int


class AnswerCache:
    """Sends what is cached, and keeps what is small and belongs to a state. The least recently used goes first."""

    def __init__(self, app: ASGIApp, library: Library, most_bytes: int) -> None:
        self._app = app
        self._library = library
        self._most_bytes = most_bytes
        self._cached: OrderedDict[Key, CachedAnswer] = OrderedDict()
        self._bytes = 0

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer, or pass the request on and keep its answer."""
        if scope["type"] != "http" or scope["method"] != "GET" or not self._most_bytes:
            await self._app(scope, receive, send)
            return
        asked = {name: value for name, value in scope["headers"] if name in _ASKED}
        forms = liked_types(asked.get(b"accept", b"*/*").decode("latin-1"))
        key = (scope["path"], scope["query_string"], forms, asked.get(b"accept-encoding", b""))
        cached = self._cached.get(key)
        is_present = cached is not None and self._library.find(cached.hosted.source.id) is cached.hosted
        if cached is not None and is_present and _WANTED not in asked:
            await self._send_cached(cached, key, asked.get(b"if-none-match"), scope, send)
            return
        await self._app(scope, receive, _CachingSend(self, key, scope, send))

    async def _send_cached(self, cached: CachedAnswer, key: Key, known: bytes | None, scope: Scope, send: Send) -> None:
        self._cached.move_to_end(key)
        scope["state"]["route"] = cached.route
        if known is not None and is_known(known.decode("latin-1"), cached.etag):
            same = (pair for pair in cached.start["headers"] if pair[0] in _SENT_WITH_304)
            headers = [*same, (b"vary", VARY_OF_304.encode())]
            await send({"type": "http.response.start", "status": 304, "headers": headers})
            await send({"type": "http.response.body", "body": b""})
            return
        await send({**cached.start, "headers": list(cached.start["headers"])})
        await send(cached.body)

    def add(self, key: Key, cached: CachedAnswer) -> None:
        """Keep an answer, and forget the oldest ones beyond the bound."""
        earlier = self._cached.pop(key, None)
        self._bytes += cached.size - (earlier.size if earlier else 0)
        self._cached[key] = cached
        while self._bytes > self._most_bytes:
            self._bytes -= self._cached.popitem(last=False)[1].size


class _CachingSend:
    """Passes messages on, and keeps an answer that comes in one piece."""

    def __init__(self, answers: AnswerCache, key: Key, scope: Scope, send: Send) -> None:
        self._answers = answers
        self._key = key
        self._scope = scope
        self._send = send
        self._start: Message | None = None

    async def __call__(self, message: Message) -> None:
        """One message of the answer."""
        if message["type"] == "http.response.start":
            copied = {**message, "headers": list(message["headers"])}
            self._start = copied if message["status"] == 200 else None
        elif self._start is not None:
            self._keep(self._start, message)
            self._start = None
        await self._send(message)

    def _keep(self, start: Message, body: Message) -> None:
        state = self._scope.get("state", {})
        hosted = state.get("hosted")
        size = len(body.get("body", b"")) + 1000
        if hosted is None or body.get("more_body") or size > _LARGEST or "caching" not in state:
            return
        if state.get("is_head"):  # it may have been made without its body
            return
        etag = state["caching"]["ETag"]
        route = state.get("route") or getattr(self._scope.get("route"), "path", "")
        self._answers.add(self._key, CachedAnswer(hosted, etag, route, start, dict(body), size))
