"""Clients that want to keep others out: `python -m tests.api.attackers NAME HOST PORT` attacks until it is killed.

Each holds connections, or asks some hundred times in a second: it tries what a request may do, not how fast the machine is. It says
`ready` when the attack is under way.
"""

import asyncio
import sys
from collections.abc import Awaitable, Callable, Iterator, Mapping
from contextlib import suppress
from itertools import count, cycle

SOURCE = "127.0.0.2"
"""The attackers' address, another one than that of the ordinary client."""
TREE = "/api/v1/catalogues/local"
EXPORTS = (
    "apigear",
    "binary",
    "csv",
    "ddsidl",
    "graphql",
    "id",
    "json",
    "jsonschema",
    "protobuf",
    "ros2interface",
    "tree",
    "yaml",
)
_PAUSE = 0.01
_AGAIN = 5
_HEAD = b"%b %b HTTP/1.1\r\nHost: a\r\n"

Streams = tuple[asyncio.StreamReader, asyncio.StreamWriter]


class Target:
    """The service that is attacked."""

    def __init__(self, host: str, port: int) -> None:
        self._host = host
        self._port = port
        self._connected = asyncio.Semaphore(0)

    async def connected(self, times: int) -> None:
        """Wait until there were as many connections."""
        for _ in range(times):
            await self._connected.acquire()

    async def connect(self) -> Streams:
        """A connection; it may be closed at once. What comes is not read on its own."""
        streams = await asyncio.open_connection(self._host, self._port, local_addr=(SOURCE, 0), limit=1)
        self._connected.release()
        return streams

    async def held(self, sent: bytes) -> None:
        """A connection that sends this and then nothing, and again when it was closed."""
        while True:
            with suppress(OSError):
                reader, writer = await self.connect()
                writer.write(sent)
                while await reader.read(65536):
                    pass
                writer.close()
            await asyncio.sleep(_AGAIN)


def head(method: str, path: str, *headers: str) -> bytes:
    """The beginning of a request."""
    return b"\r\n".join([f"{method} {path} HTTP/1.1".encode(), b"Host: a", *map(str.encode, headers), b""])


async def _hold(target: Target, number: int, sent: bytes) -> None:
    for _ in range(number):
        _TASKS.append(asyncio.create_task(target.held(sent)))
        await asyncio.sleep(0)


async def half_heads(target: Target) -> None:
    """1,100 requests whose headers never end."""
    await _hold(target, 1100, head("GET", "/"))


async def silent(target: Target) -> None:
    """1,500 connections on which nothing is sent."""
    await _hold(target, 1500, b"")


async def stalled_bodies(target: Target) -> None:
    """150 bodies of 4 MB without their last byte."""
    body = b" " * (4 * 1024 * 1024 - 1)
    await _hold(target, 150, head("POST", "/api/v1/lint", f"Content-Length: {len(body) + 1}") + b"\r\n" + body)


async def dripping(target: Target) -> None:
    """300 requests that send a byte of a header now and then."""

    async def drip() -> None:
        while True:
            with suppress(OSError):
                _, writer = await target.connect()
                writer.write(head("GET", "/") + b"X: ")
                while not writer.is_closing():
                    writer.write(b"x")
                    await asyncio.sleep(0.5)
            await asyncio.sleep(_AGAIN)

    _TASKS.extend(asyncio.create_task(drip()) for _ in range(300))


async def unread(target: Target) -> None:
    """200 long answers that are not read."""

    async def ask() -> None:
        while True:
            with suppress(OSError):
                reader, writer = await target.connect()
                writer.transport.pause_reading()  # type: ignore[attr-defined]
                writer.write(head("GET", f"{TREE}/tree?depth=20", "Accept-Encoding: identity") + b"\r\n")
                await asyncio.sleep(30)
                del reader

    _TASKS.extend(asyncio.create_task(ask()) for _ in range(200))


async def pipelined(target: Target) -> None:
    """Thousands of requests at once on each of ten connections."""
    await _hold(target, 10, (head("GET", f"{TREE}/nodes/Vehicle.S7") + b"\r\n") * 5000)


async def pages(target: Target) -> None:
    """The longest page, thirty times on each of ninety connections."""
    await _hold(target, 90, (head("GET", "/docs") + b"\r\n") * 30)


async def empty_headers(target: Target) -> None:
    """500 requests of tens of thousands of headers that are next to nothing."""
    await _hold(target, 500, head("GET", "/") + b"A:\r\n" * 30_000)


def _asking(requests: Callable[[], Iterator[bytes]], clients: int = 1) -> Callable[[Target], Awaitable[None]]:
    """An attack by requests, those of a client one after the other, each on a separate connection."""

    async def attack(target: Target) -> None:
        async def ask() -> None:
            for request in requests():
                with suppress(OSError, TimeoutError):
                    reader, writer = await target.connect()
                    writer.write(request)
                    async with asyncio.timeout(5):
                        await reader.read(65536)
                    writer.close()
                await asyncio.sleep(_PAUSE)

        _TASKS.extend(asyncio.create_task(ask()) for _ in range(clients))

    return attack


def _long_answers() -> Iterator[bytes]:
    for address in cycle(["/api/v1/rules", f"{TREE}/nodes?limit=200", f"{TREE}/units", TREE]):
        yield head("GET", address, "Accept: application/yaml", "Connection: close") + b"\r\n"


def _invented() -> Iterator[bytes]:
    for number in count():
        yield head(f"INVENTED{number}", "/") + b"\r\n"
        yield head("GET", f"/invented/{number}", f"X-{number}: 1", f"X-Request-Id: invented-{number}") + b"\r\n"
        yield head("GET", f"{TREE}/nodes/Vehicle.S7?invented{number}=1") + b"\r\n"


def _repeated_headers() -> Iterator[bytes]:
    for number in count():
        accepted = [f"Accept: {','.join(f'text/a{number % 1000}b{each}' for each in range(24))}" for _ in range(90)]
        yield head("GET", f"{TREE}/nodes/Vehicle.S7", *accepted) + b"\r\n"


def _heads_of_exports() -> Iterator[bytes]:
    for name in cycle(EXPORTS):
        yield head("HEAD", f"{TREE}/export/{name}") + b"\r\n"


def _no_requests() -> Iterator[bytes]:
    chunked = head("POST", "/api/v1/lint", "Transfer-Encoding: chunked") + b"\r\n"
    yield from cycle((
        b"\x16\x03\x01\x02\x00" * 20, b"GET / HTTP/1.1\r\nX: " + b"x" * 100_000, chunked + b"zz\r\n", b"\r\n" * 1000,
        chunked + b"0\r\n" + b"X: x\r\n" * 20_000, chunked + b"1\r\n \r\n" * 20_000, head("GET", "/", "Content-Length: 1", "Content-Length: 2"),
    ))  # fmt: skip


def _left_at_once() -> Iterator[bytes]:
    for number in count():
        yield head("POST", "/api/v1/lint", "Content-Length: 1000") + b"\r\nVehicle"
        yield head("GET", f"{TREE}/search?q={number}") + b"\r\n"


async def leaving(target: Target) -> None:
    """Clients that leave before they are answered."""

    async def leave() -> None:
        for request in _left_at_once():
            with suppress(OSError):
                _, writer = await target.connect()
                writer.write(request)
                await asyncio.sleep(_PAUSE)
                writer.transport.abort()

    _TASKS.append(asyncio.create_task(leave()))


_TASKS: list[asyncio.Task[None]] = []
ATTACKS: Mapping[str, Callable[[Target], Awaitable[None]]] = {
    "silent connections": silent,
    "half-sent headers": half_heads,
    "headers that drip": dripping,
    "stalled bodies": stalled_bodies,
    "unread answers": unread,
    "thousands of requests at once": pipelined,
    "thousands of pages": pages,
    "thousands of empty headers": empty_headers,
    "invented methods, paths, parameters": _asking(_invented),
    "as many repeated headers as fit": _asking(_repeated_headers),
    "40 clients of long YAML": _asking(_long_answers, clients=40),
    "HEAD on every export": _asking(_heads_of_exports),
    "malformed requests": _asking(_no_requests),
    "clients that leave": leaving,
}


async def main() -> None:
    """Attack until killed."""
    name, host, port = sys.argv[1:]
    target = Target(host, int(port))
    await ATTACKS[name](target)
    await target.connected(len(_TASKS))
    print("ready", flush=True)
    await asyncio.sleep(600)


if __name__ == "__main__":
    asyncio.run(main())
