"""Request headers as the application may rely on them.

A client may send a header that is a list several times; all of them are one list (RFC 9110, 5.3). Whatever answers, packs or keeps
an answer sees the same value. Readers that took the first or the last of them would disagree, and one client's form of an answer
would be kept for others.

No answer depends on `Host`, which a client chooses freely: addresses in answers, redirects included, are relative. Only what refuses
pages of other sites reads it, from the state of the request.
"""

from starlette.types import ASGIApp, Receive, Scope, Send

from sigcat.api.answers.negotiation import accepts_gzip

_LISTS = (b"accept", b"accept-encoding", b"if-match", b"if-none-match")
_LEFT_OUT = (*_LISTS, b"host")


class RequestHeaders:
    """Joins what was sent in several lines, says of encodings whether gzip is allowed, the only one that is sent, and leaves out `Host`."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on with one line for each of these headers."""
        if scope["type"] == "http":
            scope.setdefault("state", {})["host"] = dict(scope["headers"]).get(b"host", b"").decode("latin-1")
            scope["headers"] = _joined(scope["headers"])
            scope["server"] = None  # Starlette makes addresses of it, where there is no `Host`
        await self._app(scope, receive, send)


def _joined(headers: list[tuple[bytes, bytes]]) -> list[tuple[bytes, bytes]]:
    lists: dict[bytes, list[bytes]] = {}
    for name, value in headers:
        if name in _LISTS:
            lists.setdefault(name, []).append(value)
    whole = {name: b", ".join(values) for name, values in lists.items()}
    encodings = whole.get(b"accept-encoding", b"").decode("latin-1")
    whole[b"accept-encoding"] = b"gzip" if accepts_gzip(encodings) else b"identity"
    return [*(pair for pair in headers if pair[0] not in _LEFT_OUT), *whole.items()]
