"""A request and its answer: the part of uvicorn that writes answers, made faster."""

import re
from functools import lru_cache
from typing import Any

from uvicorn._types import ASGISendEvent
from uvicorn.protocols.http.httptools_impl import STATUS_LINE, RequestResponseCycle

_COPIED = 64 * 1024
"""Bytes of an answer that are faster copied behind its head than written apart from it."""
_FRAMING = frozenset((b"content-length", b"transfer-encoding", b"connection"))
_OF_EACH = frozenset((b"content-length", b"x-request-id"))
"""Headers with another value in nearly every answer. All others are mostly those of the answer before."""
_HEADER = re.compile(rb"[^\x00-\x1f\x7f()<>@,;:\[\]={} \\\"]+: [^\x00-\x08\x0a-\x1f\x7f]*\r\n")  # as uvicorn has it


class Exchange(RequestResponseCycle):
    """An exchange of uvicorn that sends the head with the first part of a body, and checks each header line once."""

    _unsent_head = b""
    _says_close = False

    async def send(self, message: ASGISendEvent) -> None:
        """Take a part of the answer."""
        if self.flow.write_paused and not self.disconnected:
            await self.flow.drain()
        if self.disconnected:
            return
        if not self.response_started and message["type"] == "http.response.start":
            self.response_started = True
            self.waiting_for_100_continue = False
            self._unsent_head = self._head(message)
            if self.chunked_encoding:  # its parts may be long in coming
                self._send_head()
        elif self._unsent_head and message["type"] == "http.response.body" and self._is_whole(message):
            self._send_whole(message.get("body", b""))
        else:
            self._send_head()
            await super().send(message)

    def _is_whole(self, message: Any) -> bool:
        return not message.get("more_body") and (
            self.scope["method"] == "HEAD" or len(message.get("body", b"")) == self.expected_content_length
        )

    def _send_head(self) -> None:
        if self._unsent_head:
            self.transport.write(self._unsent_head)
            self._unsent_head = b""

    def _send_whole(self, body: bytes) -> None:
        if self.scope["method"] == "HEAD":
            self._send_head()
        elif len(body) > _COPIED:
            self.transport.writelines((self._unsent_head, body))
        else:
            self.transport.write(self._unsent_head + body)
        self._unsent_head = b""
        self.response_complete = True
        self.message_event.set()
        if not self.keep_alive:
            self.transport.close()
        self.on_response()

    def _head(self, message: Any) -> bytes:
        """The lines of the head. Raises RuntimeError for a header that would break them."""
        status = message["status"]
        lines = [STATUS_LINE[status]]
        for name, value in (*self.default_headers, *message.get("headers", ())):
            small = name.lower()
            if small in _FRAMING:
                self._frame(small, value)
            lines.append(_line(small, value) if small in _OF_EACH else _kept_line(small, value))
        return b"".join((*lines, self._framing(status), b"\r\n"))

    def _frame(self, name: bytes, value: bytes) -> None:
        """Note what a header says of the length of the answer, or of the connection."""
        if name == b"content-length" and self.chunked_encoding is None:
            self.expected_content_length = int(value)
            self.chunked_encoding = False
        elif name == b"transfer-encoding" and value.lower() == b"chunked":
            self.expected_content_length = 0
            self.chunked_encoding = True
        elif name == b"connection" and b"close" in value.lower().replace(b",", b" ").split():
            self.keep_alive = False
            self._says_close = True

    def _framing(self, status: int) -> bytes:
        """Lines that the application left to the server."""
        lines = b"" if self.keep_alive or self._says_close else b"connection: close\r\n"
        if self.chunked_encoding is None and self.scope["method"] != "HEAD" and status not in (204, 304):
            self.chunked_encoding = True
            lines += b"transfer-encoding: chunked\r\n"
        return lines


def _line(name: bytes, value: bytes) -> bytes:
    """The line of a header. Raises RuntimeError for one that would be more than a line."""
    line = b"%b: %b\r\n" % (name, value)
    if not _HEADER.fullmatch(line):
        raise RuntimeError(f"The header {name!r} of an answer has characters that no header may have.")
    return line


_kept_line = lru_cache(512)(_line)
