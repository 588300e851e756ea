"""HTTP as clients really send it: `uvicorn --http sigcat.api.connections.http:HttpConnection`, which `sigcat serve` uses.

uvicorn reads requests and answers them. Here is what it leaves open: a client that never ends the head of a request, sends one
without end, never reads its answer, or opens connections without end.
"""

import asyncio
import re
from functools import lru_cache
from http import HTTPStatus
from typing import Any, NamedTuple
from urllib.parse import unquote

import httptools
from uvicorn._types import ASGI3Application
from uvicorn.config import Config
from uvicorn.protocols.http.httptools_impl import HttpToolsProtocol, RequestResponseCycle
from uvicorn.server import ServerState

from sigcat.api.client_network import network_of
from sigcat.api.connections.exchange import Exchange
from sigcat.api.connections.open_connections import OpenConnections
from sigcat.api.connections.refusals import Refusals, Refused
from sigcat.api.connections.request_starts import RequestStarts
from sigcat.api.connections.unread_answers import UnreadAnswers
from sigcat.api.work.refusals import RETRY_SECONDS

HEAD_BYTES = 32 * 1024
"""Bytes of the address and the headers of a request."""
HEADERS = 100
"""Headers of a request. Each costs more memory than its bytes, and no client sends half as many."""
_AROUND_HEADER = len(": \r\n")
_AROUND_CHUNK = len("0123456789abcdef\r\n\r\n")
CHUNK_BYTES = 32 * 1024
"""Bytes of all chunk extensions of a request. No application reads them."""
_HOST = re.compile(rb"(?:\[[\w.:~!$&'()*+,;=%-]+\]|[\w.~!$&'()*+,;=%-]*)(?::\d*)?")
"""A name or an address, and perhaps a port (RFC 3986, 3.2)."""
_DOTS = re.compile(rb"(?:/|%2F)(?:\.|%2E){1,2}(?=/|%2F|$)", re.IGNORECASE)
_HTTP_2 = b"PRI"
"""The method with which its clients begin."""
_PIPELINED = 32
"""Requests of one connection that wait for the answer to another one before them."""
_LINGERING_SECONDS = 2.0
"""Seconds in which a client may read why it was refused, before the connection is closed."""
_DISCARDED_BYTES = 16 * 1024 * 1024
"""Bytes of a body that are read after its answer: clients that send all of it first read the answer only then."""

_NO_METHOD = (
    "A request must begin with a method of HTTP in capitals, such as `GET`. This address speaks neither TLS nor HTTP/2."
)
_NO_PATH = "The address must be a path such as `/docs`, in ASCII: write any other character as `%C3%A4`."
_NO_HEAD = (
    "A request must begin with the line `METHOD ADDRESS HTTP/1.1`, where the version may be 1.0 too, then headers "
    "`NAME: VALUE`, such as `Host`. Each line ends with CR LF."
)
_NO_HEADERS = (
    "Each header must be one line `NAME: VALUE`, of letters that are seen, and end with CR LF. `Content-Length` must be "
    "a number of bytes, there once, and not beside `Transfer-Encoding`."
)
_NO_CHUNKS = (
    "The body must come in chunks, as `Transfer-Encoding` says: a chunk size in hexadecimal digits, CR LF, as many "
    "bytes, CR LF. The last chunk has the size 0; behind it may stand headers `NAME: VALUE`."
)
_NOTHING_FOLLOWS = "Nothing may follow a request that closes the connection. Send it on another one."


class ConnectionRules(NamedTuple):
    """Rules for the connections of a process; in the state that the application gives its server."""

    open_connections: OpenConnections
    request_starts: RequestStarts
    unread_answers: UnreadAnswers
    refusals: Refusals
    head_seconds: float
    unread_seconds: float


class HttpConnection(HttpToolsProtocol):
    """A connection whose requests come whole and in time, or are refused with a problem."""

    def __init__(
        self,
        config: Config,
        server_state: ServerState,
        app_state: dict[str, Any],
        _loop: asyncio.AbstractEventLoop | None = None,
    ) -> None:
        super().__init__(config, server_state, app_state, _loop)
        self._rules: ConnectionRules = app_state["connection_rules"]
        self.url = b""
        self._network = ""
        self._has_room = True
        self._is_in_head = False
        self._head_bytes = 0
        self._header_count = 0
        self._content_bytes = 0
        self._extension_bytes = 0
        self._discarded_bytes = 0
        self._is_ending = False
        self._answering: tuple[RequestResponseCycle, asyncio.Task[None]] | None = None
        self._head_timer: asyncio.TimerHandle | None = None
        self._unread_timer: asyncio.TimerHandle | None = None

    # -- the connection -------------------------------------------------------------------------------------------

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Let it in; without room, its first request will be refused."""
        super().connection_made(transport)
        self._network = network_of(self._address)
        self._has_room = self._rules.open_connections.add(self, self._address)
        self._expect_head()

    def connection_lost(self, exc: Exception | None) -> None:
        """Forget it, and give up what it asked for."""
        self._give_up_answers()
        self._rules.open_connections.remove(self)
        self._rules.unread_answers.remove(self)
        self._stop_expecting_head()
        self._stop_expecting_reading()
        super().connection_lost(exc)

    def data_received(self, data: bytes) -> None:
        """Read on; what follows the last answer is discarded."""
        if self._is_ending:
            self._discard(len(data))
            return
        self._unset_keepalive_if_required()
        self._rules.open_connections.heard_from(self)
        began_in_head, began_in_body = self._is_in_head, self._in_body
        self._content_bytes = 0
        try:
            self._feed(data)
            if began_in_head and self._is_in_head:
                self._count_head(len(data))
            if began_in_body is not None and began_in_body is self._in_body:
                self._count_extensions(len(data) - self._content_bytes)
        except httptools.HttpParserCallbackError as error:
            self._refuse(self._refusal_of(error.__context__ or error))
        except (httptools.HttpParserError, Refused) as error:
            self._refuse(self._refusal_of(error))
        if self._head_timer is None and not self._is_ending and (self._is_in_head or not self._is_under_way):
            self._expect_head()

    @property
    def waits_for_its_client(self) -> bool:
        """Whether nothing is done for it until more comes."""
        is_all_there = self._is_under_way and not self.cycle.more_body
        return not (is_all_there or self.pipeline or self.unread)

    def give_way(self) -> None:
        """Close it, so that another one has room."""
        self.transport.close()

    @property
    def _is_under_way(self) -> bool:
        return self.cycle is not None and not self.cycle.response_complete

    @property
    def _in_body(self) -> RequestResponseCycle | None:
        """The request of which a part of the body is still to come."""
        return self.cycle if self.cycle is not None and self.cycle.more_body and not self._is_in_head else None

    @property
    def _address(self) -> str:
        return self.client[0] if self.client else ""

    # -- the head of a request ------------------------------------------------------------------------------------

    def on_message_begin(self) -> None:
        """A request begins."""
        self.url = b""
        self.headers = []
        self.expect_100_continue = False
        self._is_in_head = True
        self._head_bytes = self._header_count = self._extension_bytes = self._discarded_bytes = 0

    def on_url(self, url: bytes) -> None:
        """A part of its address."""
        self._count_head(len(url))
        self.url += url

    def on_header(self, name: bytes, value: bytes) -> None:
        """A header, without the spaces around its value; a line after a body in chunks is not one."""
        self._header_count += 1
        self._count_head(len(name) + len(value) + _AROUND_HEADER)
        if self._is_in_head:
            self.headers.append((name.lower(), value.strip(b" \t")))

    def on_headers_complete(self) -> None:
        """Hand the request to the application, if it is one."""
        self._is_in_head = False
        if self._head_timer is not None:
            self._stop_expecting_head()
        if not self._has_room:
            raise Refused(
                HTTPStatus.SERVICE_UNAVAILABLE,
                "The service has as many connections at work as it may have. Try again later.",
                [(b"retry-after", b"%d" % RETRY_SECONDS)],
            )
        self._check_head()
        if not self.parser.should_upgrade():
            self._answer()

    def on_chunk_header(self) -> None:
        """A chunk of the body begins."""
        self._content_bytes += _AROUND_CHUNK

    def on_body(self, body: bytes) -> None:
        """A part of the body."""
        self._content_bytes += len(body)
        if self.cycle.response_complete:
            self._discard(len(body))
        else:
            super().on_body(body)

    def on_message_complete(self) -> None:
        """The request is whole."""
        if not self.parser.should_upgrade():
            super().on_message_complete()

    def _feed(self, data: bytes) -> None:
        """Parse. The parser stops at a request to speak another protocol, which is then read as if it did not ask so."""
        while data:
            try:
                self.parser.feed_data(data)
            except httptools.HttpParserUpgrade as stopped:
                data = self._without_upgrade() + data[stopped.args[0] :]
                self.parser = httptools.HttpRequestParser(
                    self
                )  # the one before reads nothing after `Connection: close`
                self.parser.set_dangerous_leniencies(lenient_data_after_close=True)
            else:
                break

    def _without_upgrade(self) -> bytes:
        headers = b"".join(b"%b: %b\r\n" % header for header in self.headers if header[0] != b"upgrade")
        version = self.parser.get_http_version().encode()
        return b"%b %b HTTP/%b\r\n%b\r\n" % (self.parser.get_method(), self.url, version, headers)

    def _count_head(self, size: int) -> None:
        self._head_bytes += size
        if self._head_bytes > HEAD_BYTES or self._header_count > HEADERS:
            detail = (
                f"The address and the headers must have at most {HEAD_BYTES:,} bytes, in at most {HEADERS} headers."
            )
            raise Refused(HTTPStatus.REQUEST_HEADER_FIELDS_TOO_LARGE, detail)

    def _count_extensions(self, size: int) -> None:
        self._extension_bytes += max(size, 0)
        if self._extension_bytes > CHUNK_BYTES:
            detail = f"Chunk extensions must have at most {CHUNK_BYTES:,} bytes in all. Send chunks without them."
            raise Refused(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, detail)

    def _check_head(self) -> None:
        """Make the scope of the request. Raises Refused for what the parser lets pass, and RFC 9112 does not."""
        version, method = self.parser.get_http_version(), self.parser.get_method()
        if version not in ("1.0", "1.1"):
            raise _bad("The version of HTTP must be 1.0 or 1.1.")
        self._check_headers(version)
        path, query = self._path_and_query()
        if not path or b"#" in self.url or method == b"CONNECT" or (path == b"*" and method != b"OPTIONS"):
            raise _bad(_NO_PATH)
        if (b"/." in path or b"%" in path) and _DOTS.search(path):
            raise _bad("The address must have no segments `.` and `..`: write the path that is meant.")
        if len(self.pipeline) >= _PIPELINED:
            raise _bad(f"At most {_PIPELINED} requests may wait for the answer to another one.")
        text = path.decode("ascii")
        self.scope = {
            "type": "http",
            "asgi": {"version": self.asgi_version, "spec_version": "2.3"},
            "http_version": version,
            "server": self.server,
            "client": self.client,
            "scheme": self.scheme,  # type: ignore[typeddict-item]
            "method": method.decode("ascii"),
            "root_path": self.root_path,
            "path": self.root_path + (unquote(text) if "%" in text else text),
            "raw_path": self.root_path.encode("ascii") + path,
            "query_string": query,
            "headers": self.headers,
            "state": {**self.app_state, "has_left": self._has_left},
        }

    def _check_headers(self, version: str) -> None:
        """Raises Refused unless `Host` and `Transfer-Encoding` are as they must be; finds both, and `Expect`, in one pass."""
        hosts, is_chunked = 0, False
        for name, value in self.headers:
            if name == b"host":
                hosts += 1
                if not _is_host(value):
                    raise _bad("The header `Host` must be a name or an address, and perhaps `:PORT`.")
            elif name == b"transfer-encoding":
                if version == "1.0" or is_chunked or value.lower() != b"chunked":
                    raise _bad("`Transfer-Encoding` must be `chunked`, and the version of HTTP 1.1.")
                is_chunked = True
            elif name == b"expect" and value.lower() == b"100-continue":
                self.expect_100_continue = True
        if hosts != 1 and (version == "1.1" or hosts):
            raise _bad("The header `Host` must be there once.")

    def _path_and_query(self) -> tuple[bytes, bytes]:
        """The path and the query of the address, which proxies may be sent with a scheme and a host before it."""
        if self.url.startswith(b"/"):
            path, _, query = self.url.partition(b"?")
            return path, query
        parsed = httptools.parse_url(self.url)
        return parsed.path, parsed.query or b""

    def _expect_head(self) -> None:
        self._head_timer = self.loop.call_later(self._rules.head_seconds, self._give_up_head)

    def _stop_expecting_head(self) -> None:
        if self._head_timer is not None:
            self._head_timer.cancel()
            self._head_timer = None

    def _give_up_head(self) -> None:
        """The time is over in which a request should have begun, or come as far as its body."""
        self._head_timer = None
        if self._is_in_head:
            detail = f"The headers must arrive within {self._rules.head_seconds:g} seconds."
            self._refuse(Refused(HTTPStatus.REQUEST_TIMEOUT, detail))
        else:
            self.transport.close()

    def _refusal_of(self, error: BaseException) -> Refused:
        """Describe the problem in our own words: the parser's are for readers of its code."""
        if isinstance(error, Refused):
            return error
        if isinstance(error, httptools.HttpParserInvalidMethodError) or self.parser.get_method() == _HTTP_2:
            return _bad(_NO_METHOD)
        if isinstance(error, httptools.HttpParserInvalidURLError):
            return _bad(_NO_PATH)
        if self._is_in_head:
            return _bad(_NO_HEADERS if self.headers else _NO_HEAD)
        return _bad(_NO_CHUNKS if self._is_under_way and self.cycle.more_body else _NOTHING_FOLLOWS)

    # -- answers --------------------------------------------------------------------------------------------------

    def _answer(self) -> None:
        """Have the request answered, at once or after those before it."""
        before = self.cycle
        self.cycle = Exchange(
            scope=self.scope,
            transport=self.transport,
            flow=self.flow,
            logger=self.logger,
            access_logger=self.access_logger,
            access_log=self.access_log,
            default_headers=self.server_state.default_headers,
            message_event=asyncio.Event(),
            expect_100_continue=self.expect_100_continue,
            keep_alive=self.scope["http_version"] != "1.0" and self.parser.should_keep_alive(),
            on_response=self.on_response_complete,
        )
        if before is None or before.response_complete:
            self._start_asgi_task(self.cycle, self.app)
        else:
            self.flow.pause_reading()
            self.pipeline.appendleft((self.cycle, self.app))

    def _start_asgi_task(self, cycle: RequestResponseCycle, app: ASGI3Application) -> None:
        """Have the application answer when it is the client's turn."""
        self._rules.request_starts.add(self._network, lambda: self._start(cycle, app))

    def _start(self, cycle: RequestResponseCycle, app: ASGI3Application) -> None:
        """Have the application answer, as long as its client waits for it."""
        if self.transport.is_closing():
            return
        task = self.loop.create_task(cycle.run_asgi(app))
        self._answering = cycle, task
        self.tasks.add(task)
        task.add_done_callback(self.tasks.discard)

    def _has_left(self) -> bool:
        """Whether the client has stopped waiting for the present answer."""
        has_left = self.transport.is_closing()
        if has_left and self._answering is not None:
            self._answering[0].disconnected = True
        return has_left

    def _give_up_answers(self) -> None:
        """Nobody will read them: not the one under way, which may not be the last request, nor those that wait for it."""
        self.pipeline.clear()
        if self._answering is not None:
            cycle, task = self._answering
            cycle.disconnected = True
            task.cancel()

    def _refuse(self, refused: Refused) -> None:
        """Answer with a problem and close. Requests before it are answered first, and the last one closes."""
        self._is_ending = True
        self._stop_expecting_head()
        path = self.url.partition(b"?")[0].decode("latin-1")
        answer = self._rules.refusals.answer(refused, path, self._address, self.server_state.default_headers)
        if self._is_under_way and not self.cycle.more_body:
            self.cycle.keep_alive = False
        elif self._is_under_way and (self.pipeline or self.cycle.response_started):
            self.transport.abort()
        else:
            self._close_with(answer)

    def _close_with(self, answer: bytes) -> None:
        if self._is_under_way:  # its body has the error: the application waits for it in vain
            self.cycle.disconnected = True
            self.cycle.message_event.set()
            self.flow.resume_reading()
        self.transport.write(answer)
        if self.transport.can_write_eof():
            self.transport.write_eof()
        self._head_timer = self.loop.call_later(_LINGERING_SECONDS, self.transport.abort)

    def on_response_complete(self) -> None:
        """The answer is made; the client has yet to read it."""
        if self._answering is not None and not self._answering[0].keep_alive:
            self._end()
        super().on_response_complete()
        self._expect_reading()

    def _end(self) -> None:
        """Close behind the last answer. A client that still sends is reset if its bytes are not read, and loses the answer.

        Therefore they are read and discarded until it closes, sends too many, or the timer of connections without requests is over.
        """
        if self._in_body is None:
            self.transport.close()
            return
        self._is_ending = True
        self.pipeline.clear()
        if self.transport.can_write_eof():
            self.transport.write_eof()

    def _discard(self, size: int) -> None:
        """Count what is read and belongs to no request that waits for an answer."""
        self._discarded_bytes += size
        if self._discarded_bytes > _DISCARDED_BYTES:
            self.transport.abort()

    def pause_writing(self) -> None:
        """The client is slower than the answer."""
        super().pause_writing()
        self._expect_reading()

    @property
    def unread(self) -> int:
        """Bytes of answers that the client has yet to read."""
        return self.transport.get_write_buffer_size()

    def cut_off(self) -> None:
        """End it, whatever of its answer is missing."""
        self.transport.abort()

    def _expect_reading(self) -> None:
        self._stop_expecting_reading()
        if unread := self.unread:
            self._unread_timer = self.loop.call_later(self._rules.unread_seconds, self._check_reading, unread)
            self._rules.unread_answers.add(self, self._network)
        else:
            self._rules.unread_answers.remove(self)

    def _stop_expecting_reading(self) -> None:
        if self._unread_timer is not None:
            self._unread_timer.cancel()
            self._unread_timer = None

    def _check_reading(self, before: int) -> None:
        """Go on as long as the client reads something."""
        if self.unread >= before:
            self.cut_off()
        else:
            self._expect_reading()


@lru_cache(256)
def _is_host(value: bytes) -> bool:
    """Whether this is a name or an address. Most requests have the same, and matching it costs as much as a header."""
    return _HOST.fullmatch(value) is not None


def _bad(detail: str) -> Refused:
    return Refused(HTTPStatus.BAD_REQUEST, detail)
