"""A local HTTP server that misbehaves: each path has a separate fault."""

import contextlib
import threading
import time
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from tests.catalogue.hosting.archives import tar_bytes

GOOD = tar_bytes()


class Handler(BaseHTTPRequestHandler):
    """Answers `GET /<fault>`; an unknown fault is 404."""

    def log_message(self, *_: Any) -> None:
        """Tests are quiet."""

    def do_GET(self) -> None:
        """Misbehave as asked."""
        fault = getattr(self, self.path.strip("/").replace("-", "_").partition(".")[0], None)
        with contextlib.suppress(OSError):
            if fault is None:
                self.send_error(404)
            else:
                fault()

    def head(self, length: int | None = None, status: int = 200, **headers: str) -> None:
        """Status line and headers."""
        self.send_response(status)
        if length is not None:
            self.send_header("Content-Length", str(length))
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()

    def good(self) -> None:
        """Requested paths."""
        self.head(len(GOOD))
        self.wfile.write(GOOD)

    def without_length(self) -> None:
        """The whole file, its length untold."""
        self.head()
        self.wfile.write(GOOD)

    def truncated(self) -> None:
        """Half of the announced bytes."""
        self.head(len(GOOD))
        self.wfile.write(GOOD[: len(GOOD) // 2])

    def truncated_without_length(self) -> None:
        """Half of the file, its length untold."""
        self.head()
        self.wfile.write(GOOD[: len(GOOD) // 2])

    def silent(self) -> None:
        """Headers, and then nothing."""
        self.head(len(GOOD))
        self.wfile.flush()
        self.rfile.read(1)  # ends when the client has gone

    def slow(self) -> None:
        """A byte now and then."""
        self.head(len(GOOD))
        for position in range(len(GOOD)):
            self.wfile.write(GOOD[position : position + 1])
            time.sleep(0.05)

    def slow_headers(self) -> None:
        """A header that does not end."""
        self.wfile.write(b"HTTP/1.1 200 OK\r\nX-Long: ")
        for _ in range(100):
            self.wfile.write(b"x")
            time.sleep(0.05)

    def endless(self) -> None:
        """More and more."""
        self.head()
        while True:
            self.wfile.write(b"\0" * 65536)

    def huge(self) -> None:
        """An announcement of 10 GB."""
        self.head(10_000_000_000)

    def moved(self) -> None:
        """A redirect to the file."""
        self.head(0, 302, Location="/good")

    def loop(self) -> None:
        """A redirect to itself."""
        self.head(0, 302, Location="/loop")

    def to_file(self) -> None:
        """A redirect to a file of the machine that asks."""
        self.head(0, 302, Location="file:///etc/passwd")

    def to_nowhere(self) -> None:
        """A redirect without an address."""
        self.head(0, 302)

    def to_other_port(self) -> None:
        """A redirect to another service of the same machine."""
        self.head(0, 302, Location="http://127.0.0.1:9/secrets")

    def to_private_https(self) -> None:
        """A redirect to this very server, as another host and over https."""
        self.head(0, 302, Location=f"https://{self.headers['Host'].replace('127.0.0.1', 'localhost')}/good")

    def to_inside(self) -> None:
        """A redirect to a name that others have at home."""
        self.head(0, 302, Location="https://inside.example/secrets")

    def no_archive(self) -> None:
        """A page in place of an archive."""
        page = b"<html>Sign in</html>" * 100
        self.head(len(page))
        self.wfile.write(page)

    def broken(self) -> None:
        """An error of the server."""
        self.head(0, 503)


@contextlib.contextmanager
def serving() -> Iterator[str]:
    """Address of the server."""
    with ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, args=(0.05,), daemon=True).start()
        try:
            yield f"http://127.0.0.1:{server.server_port}"
        finally:
            server.shutdown()
