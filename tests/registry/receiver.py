"""A receiver of webhooks on this machine, which behaves as a test asks."""

import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import NamedTuple

BIG = 10_000_000


class Request(NamedTuple):
    """A request that arrived."""

    path: str
    headers: Mapping[str, str]
    body: bytes


class Receiver(ThreadingHTTPServer):
    """It answers what `answer` returns for the number of the request: a status, or what it does instead."""

    daemon_threads = True
    block_on_close = False

    def __init__(self, answer: Callable[[int], int | str]) -> None:
        super().__init__(("127.0.0.1", 0), _Handler)
        self.answer = answer
        self.requests: list[Request] = []
        self.lock = threading.Lock()

    @property
    def url(self) -> str:
        """The address."""
        return f"http://127.0.0.1:{self.server_port}/hook?a=b"

    @property
    def ids(self) -> list[str]:
        """Ids of webhooks, in the order in which they arrived."""
        return [each.headers["webhook-id"] for each in self.requests]

    def handle_error(self, request: object, client_address: object) -> None:
        """Say nothing: the other side may end the connection."""


class _Handler(BaseHTTPRequestHandler):
    server: Receiver

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"]))
        with self.server.lock:
            self.server.requests.append(Request(self.path, dict(self.headers), body))
            answer = self.server.answer(len(self.server.requests))
        with suppress(OSError):
            self._answer(answer)

    def do_GET(self) -> None:
        with self.server.lock:
            self.server.requests.append(Request(self.path, dict(self.headers), b""))
        self._answer(200)

    def _answer(self, answer: int | str) -> None:
        if isinstance(answer, int):
            self.send_response(answer)
            if 300 <= answer < 400:
                self.send_header("Location", f"http://127.0.0.1:{self.server.server_port}/elsewhere")
            self.send_header("Content-Length", "0")
            self.end_headers()
        elif answer == "hang":
            time.sleep(20)
        elif answer == "drip":
            for letter in "HTTP/1.1 200 OK and this never ends" * 100:
                self.wfile.write(letter.encode())
                time.sleep(0.05)
        elif answer == "headers":
            self.wfile.write(b"HTTP/1.1 200 OK\r\n")
            while True:
                self.wfile.write(b"X: y\r\n" * 1000)
        elif answer == "noise":
            self.wfile.write(b"\x00\xff" * 1000)
        elif answer == "big":
            self.send_response(200)
            self.send_header("Content-Length", str(BIG))
            self.end_headers()
            self.wfile.write(b"x" * BIG)
        self.close_connection = True

    def log_message(self, *_: object) -> None:
        """Print nothing."""


@contextmanager
def receiving(answer: Callable[[int], int | str] = lambda _: 204) -> Iterator[Receiver]:
    """A receiver that runs in a thread."""
    with Receiver(answer) as receiver:
        thread = threading.Thread(target=receiver.serve_forever, args=(0.01,), daemon=True)
        thread.start()
        try:
            yield receiver
        finally:
            receiver.shutdown()
