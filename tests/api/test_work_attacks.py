"""While clients post what takes all the time or all the memory, others read as before, and the service stays small."""

import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from itertools import cycle
from statistics import median
from threading import Event
from time import perf_counter, sleep
from typing import NamedTuple

import httpx
import pytest

from sigcat.api.tokens import new_token
from tests.api.conftest import TREE
from tests.api.serving import Service, served
from tests.api.test_hostile_requests import BOMBS, HONEST
from tests.needs import slow
from tests.processes import PROC, memory
from tests.waiting import DEADLINE

pytestmark = pytest.mark.skipif(
    not (PROC / "self/smaps_rollup").exists(), reason="Linux, where the memory of processes is read from /proc"
)
SECRET, TOKEN = new_token("another", ["read"])
CLIENTS: Sequence[Mapping[str, str]] = ({}, {"Authorization": f"Bearer {SECRET}"})
"""An address, and a token: two clients."""
READ = "/api/v1/catalogues/vss/nodes/Vehicle.Speed"
OFTEN = 150
LONG = ("many paths of wildcards", "many misspelled paths", "many keys", "many includes")
LARGE = [
    b"Vehicle.X: {type: branch, instances: ['A[1,300]', 'B[1,320]'], description: X.}",
    HONEST,
    BOMBS["many anchors"],
]
"""Texts that stay within all limits, or are as large as they can be before they are refused."""
_FLOOR = """
import asyncio
async def answer(reader, writer):
    while await reader.readuntil(b"\\r\\n\\r\\n"):
        writer.write(b"HTTP/1.1 200 OK\\r\\nContent-Length: 2\\r\\n\\r\\nok")
async def main():
    server = await asyncio.start_server(answer, "127.0.0.1")
    print("http://127.0.0.1:%d" % server.sockets[0].getsockname()[1], flush=True)
    await server.serve_forever()
asyncio.run(main())
"""


TIMES = 10
"""Factor by which a request may be slower than one to an idle server."""
UNHURRIED = 0.02
"""Seconds that such a request counts for at least: of less, the ratio says nothing."""


class Watched(NamedTuple):
    """Observations of another client of the service meanwhile."""

    seconds: float
    """Median seconds of an answer."""
    floor: float
    """The same of a server that has nothing else to do, on the same machine at the same time."""
    memory: int
    """Bytes that the service held at most."""


@pytest.mark.parametrize(
    ("texts", "settings", "reasons"),
    [
        pytest.param([BOMBS[name] for name in LONG], {}, {200}, marks=slow),
        ([BOMBS[name] for name in LONG], {"SIGCAT_HEAVY_SECONDS": "0.3"}, {"longer than 0.3 seconds"}),
        (LARGE, {}, {200}),
        pytest.param(LARGE, {"SIGCAT_HEAVY_BYTES": str(8 * 1024 * 1024)}, {"more than 8 MiB of memory"}, marks=slow),
    ],
    ids=["long", "too long", "large", "too large"],
)
def test_work_of_others_keeps_nobody_from_reading(
    texts: Sequence[bytes], settings: Mapping[str, str], reasons: set[object]
) -> None:
    with served(TREE / "tree.vspec", SIGCAT_TOKENS=str(TOKEN), **settings) as service, floor() as nothing:
        lint(service, b"Vehicle: {}")
        idle = memory(service.process.pid)
        with attacked(service, texts) as answers:
            watched = watch(service, nothing)
        assert reasons <= set(answers)
        assert watched.seconds < TIMES * max(watched.floor, UNHURRIED)
        assert watched.memory < 2 * idle
        assert lint(service, b"Vehicle: {}").status_code == 200


def test_work_of_one_client_does_not_keep_another_from_working() -> None:
    with served(TREE / "tree.vspec", SIGCAT_TOKENS=str(TOKEN), SIGCAT_HEAVY_SECONDS="30") as service:
        lint(service, b"Vehicle: {}")
        with attacked(service, [BOMBS[name] for name in LONG], CLIENTS[:1]):
            answers = [lint(service, b"Vehicle: {}", CLIENTS[1]).status_code for _ in range(20)]
        assert set(answers) == {200}


def lint(service: Service, text: bytes, headers: Mapping[str, str] = CLIENTS[0]) -> httpx.Response:
    address = f"{service.address}/api/v1/lint?catalogue=vss"
    return httpx.post(address, content=text, headers=headers, timeout=DEADLINE)


@contextmanager
def attacked(
    service: Service, texts: Sequence[bytes], clients: Sequence[Mapping[str, str]] = CLIENTS
) -> Iterator[Counter[object]]:
    """Clients post again and again; what they were answered: statuses, and why there was none."""
    ended, answers = Event(), Counter[object]()

    def post(headers: Mapping[str, str]) -> None:
        for text in cycle(texts):
            answer = lint(service, text, headers)
            detail = answer.json().get("detail", "")
            answers[answer.status_code] += 1
            answers.update(
                reason for reason in ("longer than 0.3 seconds", "more than 8 MiB of memory") if reason in detail
            )
            if ended.is_set():
                return
            sleep(0.01)

    with ThreadPoolExecutor(6) as threads:
        posts = [threads.submit(post, headers) for headers in clients for _ in range(3)]
        try:
            yield answers
        finally:
            ended.set()
    for each in posts:
        each.result()


def watch(service: Service, nothing: str) -> Watched:
    """Ask for a node, again and again."""
    taken: list[tuple[float, float]] = []
    held = []
    with httpx.Client(timeout=DEADLINE) as client:
        for number in range(OFTEN):
            taken.append((seconds_for(client, service.address + READ), seconds_for(client, nothing)))
            if number % 5 == 0:
                held.append(memory(service.process.pid))
            sleep(0.01)
    seconds, floors = zip(*taken, strict=True)
    return Watched(median(seconds), median(floors), max(held))


def seconds_for(client: httpx.Client, address: str) -> float:
    start = perf_counter()
    assert client.get(address).status_code == 200
    return perf_counter() - start


@contextmanager
def floor() -> Iterator[str]:
    """A server that does nothing else than to answer."""
    with subprocess.Popen([sys.executable, "-c", _FLOOR], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.kill()
