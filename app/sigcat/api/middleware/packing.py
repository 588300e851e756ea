"""Answers packed with gzip, for clients that allow it."""

from fastapi.middleware.gzip import GZipMiddleware
from starlette.datastructures import MutableHeaders
from starlette.types import Message, Receive, Scope, Send

from sigcat.api.answers.negotiation import VARY_OF_304

_ALLOWED = (b"accept-encoding", b"gzip")
"""As `RequestHeaders` says it."""
_ENCODING = b"Accept-Encoding"
_VARIES = (b"vary", VARY_OF_304.encode())
"""As most answers have it: it is found faster than its part."""


class Packing(GZipMiddleware):
    """Starlette's, which looks at each answer to everybody else, too: that takes longer than sending one that is kept."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
        elif _ALLOWED in scope["headers"]:
            await super().__call__(scope, receive, _weakening(send))
        else:
            await self.app(scope, receive, _varying(send))


def _weakening(send: Send) -> Send:
    """Says that a packed answer is not, byte for byte, the one that has a strong `ETag` (RFC 9110, 8.8.3)."""

    async def weakening_send(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = MutableHeaders(raw=message["headers"])
            tag = headers.get("etag", "")
            if tag.startswith('"') and "content-encoding" in headers:
                headers["etag"] = f"W/{tag}"
        await send(message)

    return weakening_send


def _varying(send: Send) -> Send:
    """Says that it might have been packed."""

    async def varying_send(message: Message) -> None:
        if message["type"] == "http.response.start":
            headers = message.setdefault("headers", [])
            if _VARIES not in headers and not any(name == b"vary" and _ENCODING in value for name, value in headers):
                MutableHeaders(raw=headers).add_vary_header("Accept-Encoding")
        await send(message)

    return varying_send
