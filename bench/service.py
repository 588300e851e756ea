"""Measure the service: one worker on one core, load from the other, each figure beside its floor in the same run.

The floor is a FastAPI route that returns bytes made beforehand, in the same server.
"""

import asyncio
import contextlib
import os
import re
import resource
import subprocess
import sys
from collections.abc import Iterable, Iterator, Sequence
from itertools import cycle, islice
from pathlib import Path
from random import Random
from statistics import median
from time import perf_counter
from typing import NamedTuple

from bench.measuring import ROOT

_FLOOR = """
from fastapi import FastAPI
from fastapi.responses import Response
from sigcat.api.server import run
from sigcat.api.settings import Settings
application = FastAPI()
application.state.library = ()
BODY = b"x" * 2000
@application.get("/floor")
async def floor() -> Response:
    return Response(BODY, media_type="application/json")
run(application, Settings(port=0, log="none"))
"""
_SERVICE = """
from sigcat.api.application import create_app
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, shipped_sources
settings = Settings(port=0, log="none")
run(create_app(Library(shipped_sources()[1:]), settings), settings)
"""
_VSS = "/api/v1/catalogues/vss"
_CLIENTS = 10
_LONGEST_ANSWER = 64 * 1024 * 1024
_OVERLAY = "".join(
    f"Vehicle.Bench{n}:\n  type: sensor\n  datatype: float\n  unit: km/h\n  description: Signal number {n} of a test.\n\n"
    for n in range(20)
)


class Server(NamedTuple):
    """A server in a process of its own."""

    place: str
    """Host and port."""
    process: int

    @property
    def memory(self) -> int:
        """Bytes that it holds."""
        pages = int(Path(f"/proc/{self.process}/statm").read_text().split()[1])
        return pages * resource.getpagesize()


class Load(NamedTuple):
    """What ten clients got: requests in a second, and seconds of each."""

    rate: float
    seconds: Sequence[float]

    @property
    def p99(self) -> float:
        """Seconds within which 99 of 100 were answered."""
        return sorted(self.seconds)[int(len(self.seconds) * 0.99)]


def rows(runs: int, count: int = 3000) -> Iterator[tuple[str, str, str, str, str]]:
    """Work, figure, reference, ratio and what is wanted, for each row."""
    yield from _speed(runs, count)
    yield memory()


def memory(count: int = 20_000) -> tuple[str, str, str, str, str]:
    """Mixed requests, as many as a busy hour has: what the process holds at their end, and what in their middle."""
    with _server(_SERVICE) as service:
        requests = _mixed(service.place)
        held = []
        for _ in range(2):
            asyncio.run(_sent(service.place, islice(requests, count // 2)))
            held.append(service.memory)
        middle, end = held
    work = f"memory after {count:,} mixed requests"
    return (
        work,
        f"{end / 1e6:.0f} MB",
        f"in the middle: {middle / 1e6:.0f} MB",
        f"{end / middle:.2f} ×",
        "at most 1.10 ×",
    )


def _speed(runs: int, count: int) -> Iterator[tuple[str, str, str, str, str]]:
    with _server(_FLOOR) as (floor, _), _server(_SERVICE) as (service, _):
        paths = [f"{_VSS}/nodes/{path}" for path in _paths()]
        words = [f"{_VSS}/search?q={word}" for word in reversed(_words(paths))]
        tag = (("If-None-Match", _tag(service, paths[0])),)
        for work, least, addresses, headers in (
            ("node by path", 0.7, paths, ()),
            ("304", 0.8, paths, tag),
            ("search of the standard tree", 0.35, words, ()),
        ):
            asyncio.run(_load(service, iter(addresses[:2000]), (), min(len(addresses), 2000), b""))
            asked = _medians(runs, count, (service, cycle(addresses), headers), (floor, cycle(["/floor"]), ()))
            ratio = asked[0] / asked[1]
            yield (
                work,
                f"{asked[0]:.0f}/s",
                f"prebuilt bytes: {asked[1]:.0f}/s",
                f"{ratio:.2f} ×",
                f"at least {least} ×",
            )
        for work, most, address in (
            ("lint of a 2 kB overlay, ten clients, p99", 0.05, "/api/v1/lint"),
            ("composition of an overlay, ten clients, p99", 0.25, f"{_VSS}/trial"),
        ):
            posts = [_post(service, address, count // 10) for _ in range(runs + 1)][1:]  # the first one warms up
            p99, rate = (median(getattr(load, name) for load in posts) for name in ("p99", "rate"))
            yield work, f"{p99 * 1000:.0f} ms", f"{rate:.0f}/s", "", f"at most {most * 1000:.0f} ms"


def _post(place: str, address: str, count: int) -> Load:
    return asyncio.run(_load(place, cycle([address]), (), count, _OVERLAY.encode()))


def _medians(runs: int, count: int, *asked: tuple[str, Iterator[str], Sequence[tuple[str, str]]]) -> list[float]:
    """Requests in a second of each, taken in turn; the addresses go on from run to run."""
    taken = [[asyncio.run(_load(*each, count, b"")).rate for each in asked] for _ in range(runs)]
    return [median(values) for values in zip(*taken, strict=True)]


@contextlib.contextmanager
def _server(code: str) -> Iterator[Server]:
    """A server on the first core; this process moves to the last one."""
    cores = sorted(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else []
    pin = f"import os; os.sched_setaffinity(0, [{cores[0]}])\n" if len(cores) > 1 else ""
    if pin:
        os.sched_setaffinity(0, cores[-1:])
    command = [sys.executable, "-c", pin + code]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        match = re.search(r"http://(\S+)", process.stdout.readline())
        assert match, "the service did not start"
        yield Server(match[1], process.pid)
        process.terminate()
    if pin:
        os.sched_setaffinity(0, cores)


async def _load(
    place: str, addresses: Iterator[str], headers: Sequence[tuple[str, str]], count: int, body: bytes
) -> Load:
    """Ask the same of each address."""
    return await _sent(place, [_request(place, address, headers, body) for address in islice(addresses, count)])


async def _sent(place: str, requests: Iterable[bytes]) -> Load:
    """Ask from ten connections, each one request after the other."""
    waiting = iter(requests)
    seconds: list[float] = []
    start = perf_counter()
    await asyncio.gather(*(_client(place, waiting, seconds) for _ in range(_CLIENTS)))
    return Load(len(seconds) / (perf_counter() - start), seconds)


def _mixed(place: str) -> Iterator[bytes]:
    """Of a hundred requests 60 for nodes, 25 searches, ten overlays that are checked or tried, and five long answers."""
    paths = _paths()
    nodes = cycle([f"{_VSS}/nodes/{path}" for path in paths])
    words = cycle([f"{_VSS}/search?q={word}" for word in _words(paths)])
    long = cycle([f"{_VSS}/tree?depth=9", f"{_VSS}/export/json", f"{_VSS}/nodes?limit=200", f"{_VSS}/units", _VSS])
    posts = cycle(["/api/v1/lint", f"{_VSS}/trial"])
    kinds = Random(1).choices((nodes, words, posts, long), (60, 25, 10, 5), k=10_000)
    for kind in cycle(kinds):
        yield _request(place, next(kind), (), _OVERLAY.encode() if kind is posts else b"")


def _request(place: str, address: str, headers: Sequence[tuple[str, str]], body: bytes) -> bytes:
    lines = [f"{'POST' if body else 'GET'} {address} HTTP/1.1", f"Host: {place}"]
    lines += [f"{name}: {value}" for name, value in headers]
    lines += [f"Content-Length: {len(body)}"] if body else []
    return "\r\n".join([*lines, "", ""]).encode() + body


async def _client(place: str, waiting: Iterator[bytes], seconds: list[float]) -> None:
    """A client that costs as little as it can: it shares its core with the other nine."""
    host, port = place.split(":")
    reader, writer = await asyncio.open_connection(host, int(port), limit=_LONGEST_ANSWER)
    for request in waiting:
        start = perf_counter()
        writer.write(request)
        head = await reader.readuntil(b"\r\n\r\n")
        length = re.search(rb"content-length: (\d+)", head, re.IGNORECASE)
        if length:
            await reader.readexactly(int(length[1]))
        elif b"chunked" in head:
            await reader.readuntil(b"}\r\n0\r\n\r\n")
        status = head[9:12]
        assert status in (b"200", b"304"), head
        seconds.append(perf_counter() - start)
    writer.close()


def _paths() -> list[str]:
    from sigcat.catalogue.composing.compose import read_catalogue
    from sigcat.data import ROOT_FILE

    return list(read_catalogue(ROOT_FILE).nodes)


def _words(paths: Sequence[str]) -> list[str]:
    """Searches of two words, each once: none is answered from what is kept."""
    names = sorted({path.rpartition(".")[2] for path in paths})
    return [f"{a}+{b[:3]}" for a in names[:150] for b in names[150:260]]


def _tag(place: str, address: str) -> str:
    import urllib.request

    with urllib.request.urlopen(f"http://{place}{address}") as answer:
        return str(answer.headers["ETag"])


def main() -> int:
    """Print the table."""
    print("| work | sigcat | reference | ratio | wanted |\n|---|---|---|---|---|")
    for row in rows(runs=int(sys.argv[1]) if len(sys.argv) > 1 else 3):
        print(f"| {' | '.join(row)} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
