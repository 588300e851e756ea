"""Fetch one file over HTTP, with bounds on size, time, redirects, and on which addresses are asked.

An address may point anywhere: into the network of the machine that asks, or at its files. Hosts have to be at public addresses;
the one that the user named may be private if the user says so, and may be asked over http. No other one may.
"""

import http.client
import socket
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http import HTTPStatus
from pathlib import Path
from typing import IO, Any, NamedTuple
from urllib.parse import SplitResult, urljoin, urlsplit

from sigcat import __version__
from sigcat.catalogue.hosting.public_network import INTERNET, AddressRefused, Network, is_public, numeric_address
from sigcat.errors import SigcatError
from sigcat.limits import DEFAULT_FETCH_LIMITS, FetchLimits

Progress = Callable[[int, int | None], None]
"""Called after each piece: bytes so far, and bytes in all, if known."""


class FetchFailed(SigcatError):
    """The file could not be fetched; its text says why."""


class FileMissing(FetchFailed):
    """The host does not have the file."""


class _Moved(Exception):
    """The server names another address."""

    def __init__(self, address: str) -> None:
        super().__init__(address)
        self.address = address


class _Asked(NamedTuple):
    """An address to ask, and what is allowed."""

    address: str
    parts: SplitResult
    is_named: bool
    """Whether it is of the host that the user named."""
    allows_private: bool
    network: Network


def fetch(
    address: str,
    target: Path,
    *,
    is_named: bool = False,
    allows_private: bool = False,
    progress: Progress | None = None,
    limits: FetchLimits = DEFAULT_FETCH_LIMITS,
    network: Network = INTERNET,
) -> str:
    """Fetch `address` into `target`; the address that it came from in the end. Raises FetchFailed.

    `is_named`: the user named the address, so it may be http. `allows_private`: that host may be at a private address, too.
    """
    first = _split(address)
    for _ in range(limits.redirects + 1):
        parts = _split(address)
        is_first = is_named and _is_same_host(parts, first)
        asked = _Asked(address, parts, is_first, is_first and allows_private, network)
        try:
            _fetch_one(asked, target, progress or _unseen, limits)
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
    if not (address.isascii() and _is_host(parts.hostname)):
        raise FetchFailed(
            f"{address[:200]!r} is not an address as it is sent: in ASCII, a host as `xn--…`, anything else as `%C3%A4`"
        )
    return parts


def _is_host(name: str) -> bool:
    """Whether each part of a name is neither empty nor too long to be asked for."""
    try:
        name.encode("idna")
    except UnicodeError:
        return False
    return True


def _next_address(address: str, location: str) -> str:
    following = urljoin(address, location)
    scheme = urlsplit(following).scheme
    if scheme not in ("http", "https") or (urlsplit(address).scheme == "https" and scheme != "https"):
        raise FetchFailed(f"{_host(_split(address))} redirects to {following[:200]!r}, which is not followed")
    return following


def _fetch_one(asked: _Asked, target: Path, progress: Progress, limits: FetchLimits) -> None:
    if asked.parts.scheme != "https" and not asked.is_named:
        message = f"{asked.address[:200]!r} is not fetched: it must be https, except from the host that --from names"
        raise FetchFailed(message)
    try:
        with _opened(asked, limits) as response:
            _save(response, target, progress, limits)
    except AddressRefused as error:
        hint = "; --allow-private asks it all the same" if asked.is_named else ""
        raise FetchFailed(f"{_host(asked.parts)} is not asked: {error} is not a public address{hint}") from None
    except (TimeoutError, urllib.error.URLError, http.client.HTTPException, OSError) as error:
        raise _failure(asked.parts, error) from None


def _reaches_proxy(parts: SplitResult) -> bool:
    """Whether a proxy is asked, which resolves names itself."""
    return parts.scheme in urllib.request.getproxies() and not urllib.request.proxy_bypass(parts.netloc)


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
def _opened(asked: _Asked, limits: FetchLimits) -> Iterator[Any]:
    """The response, cut off when the time is up, however slowly its bytes come."""
    sockets: list[socket.socket] = []
    opener = urllib.request.build_opener(_Redirects, *_handlers(_connecting(asked), sockets))
    timer = threading.Timer(limits.total_seconds, _cut, [sockets])
    timer.daemon = True
    until = time.monotonic() + limits.total_seconds
    timer.start()
    headers = {"User-Agent": f"sigcat/{__version__}", "Accept-Encoding": "identity"}
    try:
        request = urllib.request.Request(asked.address, headers=headers)  # noqa: S310 - the scheme was checked
        with opener.open(request, timeout=limits.idle_seconds) as response:
            yield response
    except (OSError, http.client.HTTPException, FetchFailed):
        _check_time(until, asked.parts, limits)
        raise
    else:
        _check_time(until, asked.parts, limits)
    finally:
        timer.cancel()


def _check_time(until: float, parts: SplitResult, limits: FetchLimits) -> None:
    if time.monotonic() >= until:
        message = f"{_host(parts)} took longer than {limits.total_seconds:g} seconds"
        raise FetchFailed(message) from None


def _cut(sockets: list[socket.socket]) -> None:
    for sock in sockets:
        try:
            sock.shutdown(socket.SHUT_RDWR)
        except OSError:  # closed by now
            continue


class _Redirects(urllib.request.HTTPRedirectHandler):
    def http_error_302(self, req: Any, fp: Any, code: Any, msg: Any, headers: Any) -> Any:  # noqa: ARG002
        """Return the address unchanged: each one is checked before it is requested."""
        fp.close()
        location = headers.get("location")
        if not location:
            raise http.client.HTTPException(f"redirects ({code}) without an address")
        raise _Moved(location)

    http_error_301 = http_error_303 = http_error_307 = http_error_308 = http_error_302


Connect = Callable[..., socket.socket]
"""Connection factory of http.client: from a pair of host and port, and the seconds that it may take."""


def _connecting(asked: _Asked) -> Connect:
    """Connects to hosts at addresses that may be asked. A proxy may be anywhere, but not what it is asked for, as far as one can tell."""
    target = numeric_address(asked.parts.hostname or "")
    is_proxied = _reaches_proxy(asked.parts)
    if is_proxied and target is not None and not (asked.allows_private or is_public(target)):
        raise AddressRefused(target)

    def connect(place: tuple[str, int], timeout: float | None, *_: object) -> socket.socket:
        return asked.network.connected(*place, timeout, allows_private=asked.allows_private or is_proxied)

    return connect


def _handlers(connect: Connect, sockets: list[socket.socket]) -> list[Any]:
    """Handlers whose connections are made by `connect`, and put their sockets into `sockets`."""

    def noted(*arguments: Any) -> socket.socket:
        sockets.append(connect(*arguments))
        return sockets[-1]

    class Plain(http.client.HTTPConnection):
        def __init__(self, *arguments: Any, **options: Any) -> None:
            super().__init__(*arguments, **options)
            self._create_connection = noted

    class Secure(http.client.HTTPSConnection, Plain):
        def connect(self) -> None:
            super().connect()
            sockets.append(self.sock)  # encrypted, it is another one

    class HttpHandler(urllib.request.HTTPHandler):
        def http_open(self, req: Any) -> Any:
            return self.do_open(Plain, req)

    class HttpsHandler(urllib.request.HTTPSHandler):
        def https_open(self, req: Any) -> Any:
            return self.do_open(Secure, req)

    return [HttpHandler(), HttpsHandler()]


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
