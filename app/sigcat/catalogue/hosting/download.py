"""Fetch one file over HTTP, with bounds on size, time, redirects, and on which addresses are asked.

An address that a server hands out may point anywhere: into the network of the machine that asks, or at its files.
Only the host that the user named may be private; every other one has to be a public address, over https.
"""

import http.client
import ipaddress
import socket
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http import HTTPStatus
from pathlib import Path
from typing import IO, Any
from urllib.parse import SplitResult, urljoin, urlsplit

from sigcat import __version__
from sigcat.errors import SigcatError
from sigcat.limits import DEFAULT_FETCH_LIMITS, FetchLimits

Progress = Callable[[int, int | None], None]
"""Called after each piece: bytes so far, and bytes in all, if known."""


class FetchFailed(SigcatError):
    """The file could not be fetched; its text says why."""


class FileMissing(FetchFailed):
    """The host answers that there is no such file."""


class _Moved(Exception):
    """The server names another address."""

    def __init__(self, address: str) -> None:
        super().__init__(address)
        self.address = address


class _AddressRefused(Exception):
    """The host answers at an address that may not be asked."""


def fetch(
    address: str,
    target: Path,
    *,
    is_trusted: bool = False,
    progress: Progress | None = None,
    limits: FetchLimits = DEFAULT_FETCH_LIMITS,
) -> str:
    """Fetch `address` into `target`; the address that it came from in the end. Raises FetchFailed.

    `is_trusted`: the user named the address, so it may be http, and its host may be a private one.
    """
    first = _split(address)
    for _ in range(limits.redirects + 1):
        try:
            _fetch_one(address, first if is_trusted else None, target, progress or _unseen, limits)
        except _Moved as moved:
            address = _next_address(address, moved.address)
        else:
            return address
    raise FetchFailed(f"{_host(first)} redirects more than {limits.redirects} times")


def _unseen(_done: int, _total: int | None) -> None:
    """Progress that is not shown."""


def _split(address: str) -> SplitResult:
    try:
        parts = urlsplit(address)
        port = parts.port
    except ValueError as error:
        raise FetchFailed(f"{address[:200]!r} is not an address: {error}") from None
    if parts.scheme not in ("http", "https") or not parts.hostname or port == 0:
        raise FetchFailed(f"{address[:200]!r} is not an http or https address")
    return parts


def _next_address(address: str, location: str) -> str:
    following = urljoin(address, location)
    scheme = urlsplit(following).scheme
    if scheme not in ("http", "https") or (urlsplit(address).scheme == "https" and scheme != "https"):
        raise FetchFailed(f"{_host(_split(address))} redirects to {following[:200]!r}, which is not followed")
    return following


def _fetch_one(
    address: str, trusted: SplitResult | None, target: Path, progress: Progress, limits: FetchLimits
) -> None:
    parts = _split(address)
    is_named = trusted is not None and _is_same_host(parts, trusted)
    if parts.scheme != "https" and not is_named:
        raise FetchFailed(f"{address[:200]!r} is not fetched: it must be https, except from the host that --from names")
    is_proxied = parts.scheme in urllib.request.getproxies() and not urllib.request.proxy_bypass(parts.netloc)
    must_be_public = not (is_named or is_proxied)
    try:
        with _opened(address, must_be_public, limits) as response:
            _save(response, target, progress, limits)
    except _AddressRefused as error:
        raise FetchFailed(f"{_host(parts)} is not asked: {error} is not a public address") from None
    except (TimeoutError, urllib.error.URLError, http.client.HTTPException, OSError) as error:
        raise _failure(parts, error) from None


def _is_same_host(parts: SplitResult, trusted: SplitResult) -> bool:
    if parts.hostname != trusted.hostname:
        return False
    return _port(parts) == _port(trusted) or _port(parts) == 443


def _port(parts: SplitResult) -> int:
    return parts.port or (443 if parts.scheme == "https" else 80)


def _host(parts: SplitResult) -> str:
    """The host, without name and password of a user."""
    return parts.netloc.rpartition("@")[2]


@contextmanager
def _opened(address: str, must_be_public: bool, limits: FetchLimits) -> Iterator[Any]:
    """The response, cut off when the time is up, however slowly its bytes come."""
    sockets: list[socket.socket] = []
    opener = urllib.request.build_opener(_Redirects, *_handlers(must_be_public, sockets))
    timer = threading.Timer(limits.total_seconds, _cut, [sockets])
    timer.daemon = True
    until = time.monotonic() + limits.total_seconds
    timer.start()
    headers = {"User-Agent": f"sigcat/{__version__}", "Accept-Encoding": "identity"}
    try:
        request = urllib.request.Request(address, headers=headers)  # noqa: S310 - the scheme was checked
        with opener.open(request, timeout=limits.idle_seconds) as response:
            yield response
    except (OSError, http.client.HTTPException, FetchFailed):
        _check_time(until, address, limits)
        raise
    else:
        _check_time(until, address, limits)
    finally:
        timer.cancel()


def _check_time(until: float, address: str, limits: FetchLimits) -> None:
    if time.monotonic() >= until:
        message = f"{_host(_split(address))} took longer than {limits.total_seconds:g} seconds"
        raise FetchFailed(message) from None


def _cut(sockets: list[socket.socket]) -> None:
    for sock in sockets:
        try:
            sock.shutdown(socket.SHUT_RDWR)
        except OSError:  # closed by now
            continue


class _Redirects(urllib.request.HTTPRedirectHandler):
    def http_error_302(self, req: Any, fp: Any, code: Any, msg: Any, headers: Any) -> Any:  # noqa: ARG002
        """Hand the address on as it stands: each one is checked before it is asked."""
        fp.close()
        location = headers.get("location")
        if not location:
            raise http.client.HTTPException(f"redirects ({code}) without an address")
        raise _Moved(location)

    http_error_301 = http_error_303 = http_error_307 = http_error_308 = http_error_302


def _handlers(must_be_public: bool, sockets: list[socket.socket]) -> list[Any]:
    """Handlers whose connections check where they lead, and put their sockets into `sockets`."""

    class Plain(http.client.HTTPConnection):
        def connect(self) -> None:
            super().connect()
            sockets.append(self.sock)
            _check_peer(self.sock, must_be_public)

    class Secure(http.client.HTTPSConnection, Plain):
        def connect(self) -> None:  # the plain connection is checked before any encryption is talked about
            super().connect()
            sockets.append(self.sock)

    class HttpHandler(urllib.request.HTTPHandler):
        def http_open(self, req: Any) -> Any:
            return self.do_open(Plain, req)

    class HttpsHandler(urllib.request.HTTPSHandler):
        def https_open(self, req: Any) -> Any:
            return self.do_open(Secure, req)

    return [HttpHandler(), HttpsHandler()]


def _check_peer(sock: Any, must_be_public: bool) -> None:
    """Refuse a private address after connecting and before asking: what a name stands for may change in between."""
    address = str(sock.getpeername()[0]).partition("%")[0]
    if must_be_public and not ipaddress.ip_address(address).is_global:
        sock.close()
        raise _AddressRefused(address)


def _save(response: Any, target: Path, progress: Progress, limits: FetchLimits) -> None:
    length = response.headers.get("Content-Length", "")
    total = int(length) if length.isdecimal() and len(length) < 16 else None
    if total is not None and total > limits.bytes:
        raise FetchFailed(f"the file has {total:,} bytes; the limit is {limits.bytes:,}")
    with target.open("wb") as file:
        done = _copy(response, file, total, progress, limits)
    if total is not None and done != total:
        raise FetchFailed(f"the connection ended after {done:,} of {total:,} bytes")


def _copy(response: Any, file: IO[bytes], total: int | None, progress: Progress, limits: FetchLimits) -> int:
    done = 0
    while chunk := response.read1(64 * 1024):
        done += len(chunk)
        if done > limits.bytes:
            raise FetchFailed(f"the file has more than {limits.bytes:,} bytes")
        file.write(chunk)
        progress(done, total)
    return done


def _failure(parts: SplitResult, error: Exception) -> FetchFailed:
    host = _host(parts)
    if isinstance(error, urllib.error.HTTPError):
        answer = f"{host} answers {error.code} {error.reason}"
        return (
            FileMissing(f"{answer}: there is no such file")
            if error.code == HTTPStatus.NOT_FOUND
            else FetchFailed(answer)
        )
    cause = error.reason if isinstance(error, urllib.error.URLError) else error
    if isinstance(cause, TimeoutError):
        return FetchFailed(f"{host} does not answer in time")
    reason = cause.strerror if isinstance(cause, OSError) and cause.strerror else cause
    return FetchFailed(f"{host} cannot be read: {reason or type(cause).__name__}")
