"""Clients that ask a service from ten connections, and cost as little as they can: they share one core."""

import asyncio
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from time import perf_counter
from typing import NamedTuple

CLIENTS = 10
_LENGTH = re.compile(rb"content-length: (\d+)", re.IGNORECASE)


class Load(NamedTuple):
    """Results of the clients: number of answers, seconds of each, and seconds in all."""

    seconds: Sequence[float]
    whole: float

    @property
    def rate(self) -> float:
        """Answers in a second."""
        return len(self.seconds) / self.whole

    @property
    def p99(self) -> float:
        """Seconds within which 99 of 100 were answered."""
        return sorted(self.seconds)[int(len(self.seconds) * 0.99)]


def sent(place: str, requests: Iterable[bytes]) -> Load:
    """Send the requests, each connection one after the other."""
    with asyncio.Runner(loop_factory=_loop()) as runner:
        return runner.run(_sent(place, iter(requests)))


def request(place: str, address: str, headers: Sequence[tuple[str, str]] = (), body: bytes = b"") -> bytes:
    """The bytes of a request."""
    lines = [f"{'POST' if body else 'GET'} {address} HTTP/1.1", f"Host: {place}"]
    lines += [f"{name}: {value}" for name, value in headers]
    lines += [f"Content-Length: {len(body)}"] if body else []
    return "\r\n".join([*lines, "", ""]).encode() + body


def _loop() -> Callable[[], asyncio.AbstractEventLoop]:
    try:
        from uvloop import new_event_loop
    except ImportError:  # Windows
        return asyncio.new_event_loop
    return new_event_loop


async def _sent(place: str, waiting: Iterator[bytes]) -> Load:
    loop, (host, port) = asyncio.get_running_loop(), place.split(":")
    seconds: list[float] = []
    ended = [loop.create_future() for _ in range(CLIENTS)]
    start = perf_counter()
    for end in ended:
        await loop.create_connection(lambda end=end: _Client(waiting, seconds, end), host, int(port))  # type: ignore[misc]
    await asyncio.gather(*ended)
    return Load(seconds, perf_counter() - start)


class _Client(asyncio.Protocol):
    """Sends a request when the answer to the one before is whole."""

    def __init__(self, waiting: Iterator[bytes], seconds: list[float], end: "asyncio.Future[None]") -> None:
        self._waiting = waiting
        self._seconds = seconds
        self._end = end
        self._answer = bytearray()
        self._began = 0.0

    def connection_made(self, transport: asyncio.Transport) -> None:  # type: ignore[override]
        """Begin."""
        self._transport = transport
        self._ask()

    def connection_lost(self, exc: Exception | None) -> None:
        """End; too early if an answer is missing."""
        if not self._end.done():
            self._end.set_exception(exc or ConnectionError("The service closed a connection."))

    def data_received(self, data: bytes) -> None:
        """Take a part of an answer."""
        self._answer += data
        if _is_whole(self._answer):
            assert bytes(self._answer[9:12]) in (b"200", b"304"), self._answer
            self._seconds.append(perf_counter() - self._began)
            self._answer.clear()
            self._ask()

    def _ask(self) -> None:
        following = next(self._waiting, None)
        if following is None:
            self._end.set_result(None)
            self._transport.close()
            return
        self._began = perf_counter()
        self._transport.write(following)


def _is_whole(answer: bytearray) -> bool:
    head = answer.find(b"\r\n\r\n") + 4
    if head < 4:
        return False
    length = _LENGTH.search(answer, 0, head)
    if length is not None:
        return len(answer) >= head + int(length[1])
    return b"chunked" not in answer[:head] or answer.endswith(b"0\r\n\r\n")
