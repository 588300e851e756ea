"""Work that takes long: whose turn it is, and processes that are ended when it takes too long or too much."""

import asyncio
import ctypes
import gc
import importlib
import io
import itertools
import os
import re
import signal
import socket
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from starlette.requests import Request

from sigcat.api.application import create_app
from sigcat.api.requests.clients import client_of
from sigcat.api.settings import Settings
from sigcat.api.tokens import new_token
from sigcat.api.work import worker
from sigcat.api.work.queue import WorkQueue
from sigcat.api.work.references import Work, pickled, unpickled
from sigcat.api.work.refusals import BeyondShare, Busy, WorkFailed
from sigcat.api.work.turns import Turns
from sigcat.api.work.warm_zygote import WarmZygote
from sigcat.catalogue.hosting.library import Library
from sigcat.catalogue.hosting.variants import expanded_of, find_hosted
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.zygote import Zygote
from tests.api.conftest import SOURCES
from tests.own_loop import run
from tests.processes import PROC, is_running
from tests.waiting import DEADLINE, wait_until

MEBIBYTE = 1024 * 1024


# -- turns --------------------------------------------------------------------------------------------------------


class Crowd:
    """Clients whose work continues until they end it."""

    def __init__(self, turns: Turns) -> None:
        self.turns = turns
        self.begun: list[str] = []
        self.ending = asyncio.Event()

    async def work(self, client: str, ending: asyncio.Event | None = None) -> None:
        async with self.turns.turn(client):
            self.begun.append(client)
            await (ending or self.ending).wait()

    async def come(self, *clients: str) -> list["asyncio.Task[None]"]:
        tasks = [asyncio.create_task(self.work(client)) for client in clients]
        await asyncio.sleep(0)
        return tasks


def test_work_beyond_the_queue_is_refused_at_once_and_told_when_to_come_again() -> None:
    async def full() -> Busy:
        crowd = Crowd(Turns(at_once=1, waiting=1, share=1))
        tasks = await crowd.come("a", "b")
        with pytest.raises(Busy, match="full") as refused:
            await crowd.work("c")
        crowd.ending.set()
        await asyncio.gather(*tasks)
        assert crowd.turns.pending == 0
        return refused.value

    refusal: Busy = run(full())
    assert (refusal.status_code, refusal.headers) == (503, {"Retry-After": "2"})


def test_one_client_has_at_most_its_share_and_others_get_through() -> None:
    async def greedy() -> list[str]:
        crowd = Crowd(Turns(at_once=2, waiting=6, share=0.5))
        tasks = await crowd.come("greedy", "greedy", "greedy", "greedy")
        with pytest.raises(BeyondShare, match="One client may have 4") as refused:
            await crowd.work("greedy")
        assert (refused.value.status_code, refused.value.headers) == (429, {"Retry-After": "2"})
        tasks += await crowd.come("modest")
        begun = list(crowd.begun)
        crowd.ending.set()
        await asyncio.gather(*tasks)
        return begun

    assert run(greedy()) == ["greedy", "modest"]


def test_clients_take_turns() -> None:
    async def two() -> list[str]:
        crowd = Crowd(Turns(at_once=1, waiting=9, share=1))
        tasks = await crowd.come("a", "a", "a", "b", "b", "c")
        crowd.ending.set()
        await asyncio.gather(*tasks)
        return crowd.begun

    assert run(two()) == ["a", "a", "b", "c", "a", "b"]


@pytest.mark.parametrize("gone", list(itertools.permutations("abc")), ids="".join)
def test_who_goes_away_leaves_the_turn_to_others(gone: tuple[str, ...]) -> None:
    async def impatient() -> tuple[list[str], int]:
        crowd = Crowd(Turns(at_once=1, waiting=9, share=1))
        tasks = dict(zip("abcd", await crowd.come(*"abcd"), strict=True))
        for client in gone:
            tasks[client].cancel()
        await asyncio.sleep(0)
        crowd.ending.set()
        await asyncio.gather(*tasks.values(), return_exceptions=True)
        return crowd.begun, crowd.turns.pending

    assert run(impatient()) == (["a", "d"], 0)


def test_a_turn_that_was_given_to_somebody_who_goes_away_at_that_moment_is_passed_on() -> None:
    async def impatient() -> tuple[list[str], int]:
        crowd = Crowd(Turns(at_once=1, waiting=9, share=1))
        first, second, third = await crowd.come("a", "b", "c")
        first.cancel()
        await asyncio.sleep(0)
        second.cancel()
        await asyncio.gather(first, second, return_exceptions=True)
        crowd.ending.set()
        await third
        return crowd.begun, crowd.turns.pending

    assert run(impatient()) == (["a", "c"], 0)


def test_what_cannot_be_ended_has_its_turn_until_it_ends_though_nobody_waits_for_it() -> None:
    async def impatient() -> tuple[int, bool, int]:
        turns, ending = Turns(at_once=1, waiting=9, share=1), asyncio.Event()
        tasks = [asyncio.create_task(turns.to_the_end(client, ending.wait)) for client in "ab"]
        await asyncio.sleep(0)
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)
        left = turns.pending
        ending.set()
        following = await turns.to_the_end("c", ending.wait)
        return left, following, turns.pending

    assert run(impatient()) == (1, True, 0)


SECRET, TOKEN = new_token("ci", ["read"])


@pytest.mark.parametrize(
    ("host", "authorization", "client"),
    [
        ("192.0.2.1", "", "192.0.2.1"),
        ("192.0.2.1", "Bearer SECRET", "token ci"),
        ("192.0.2.1", "Bearer guess", "192.0.2.1"),
        ("2001:db8:1:2:3::1", "", "2001:db8:1:2::/64"),
        ("2001:db8:1:2:ffff::7", "", "2001:db8:1:2::/64"),
        ("::ffff:192.0.2.1", "", "192.0.2.1"),
        ("fe80::1%eth0", "", "fe80::/64"),
        ("testclient", "", "testclient"),
    ],
)
def test_a_client_is_a_token_or_else_an_address(library: Library, host: str, authorization: str, client: str) -> None:
    app = create_app(library, Settings(tokens=(TOKEN,)))
    headers = [(b"authorization", authorization.replace("SECRET", SECRET).encode())]
    assert client_of(Request({"type": "http", "app": app, "client": (host, 1), "headers": headers})) == client


# -- processes ----------------------------------------------------------------------------------------------------


@pytest.fixture
def queue() -> Iterator[WorkQueue]:
    queue = WorkQueue(1, 3, seconds=DEADLINE, memory=32 * MEBIBYTE)
    yield queue
    queue.close()


def done(queue: WorkQueue, function: Callable[..., Any], *arguments: Any) -> Any:
    return run(queue.of("a client").run(function, *arguments))


def refuse() -> None:
    raise InputRefused("Refused.", (Finding("V001", "error", "a message", "tree", 3, 4),))


def stubborn(_: object) -> None:
    """Work that holds the interpreter, so that nothing within the process could end it."""
    re.match("^(a|a|aa)*$", "a" * 60 + "b")


def crash() -> None:
    ctypes.string_at(0)


def fail_without_an_error() -> None:
    """As CPython does where it has no memory for an exception."""
    raise SystemError("<function> returned NULL without setting an exception")


def digest_of(catalogue: Catalogue) -> str:
    return catalogue.digest


def instances_behind(catalogue: Catalogue) -> tuple[int, int]:
    return len(catalogue.nodes), len(expanded_of(catalogue).nodes)


def kept_in_worker() -> int:
    return len(worker._kept)


def noted(folder: Path, text: str) -> str:
    """Note that work has begun, and continue when that is allowed."""
    with (folder / "notes").open("a") as notes:
        notes.write(text)
    wait_until((folder / "goes_on").exists, "work may continue")
    return text


async def begun(folder: Path) -> None:
    """Wait until work has begun."""
    await asyncio.to_thread(wait_until, (folder / "notes").exists, "work has begun")


def test_a_worker_does_one_piece_of_work_after_another(queue: WorkQueue) -> None:
    first = done(queue, os.getpid)
    assert first not in (os.getpid(), done(queue, os.getppid))
    assert done(queue, os.getpid) == first


def models_are_built() -> bool:
    from sigcat.function.declaration.declaration import Declaration
    from sigcat.function.function_json.interfaces.data_interfaces import Signal

    return Declaration.__pydantic_complete__ and Signal.__pydantic_complete__


def test_a_worker_does_not_build_models_again(queue: WorkQueue) -> None:
    async def asked() -> Any:
        await queue.warm(["sigcat.function.function_file"], ())
        return await queue.of("a client").run(models_are_built)

    assert run(asked())


REHEARSED: list[str] = []


def rehearse(what: str) -> None:
    REHEARSED.append(what)


def rehearsed() -> list[str]:
    return REHEARSED


def test_what_was_rehearsed_a_worker_has_and_a_rehearsal_that_fails_is_passed_over(queue: WorkQueue) -> None:
    rehearsals = [Work(int, ("x",), {}), Work(rehearse, ("overlay",), {})]

    async def asked() -> Any:
        await queue.warm([__name__], (), rehearsals)
        return await queue.of("a client").run(rehearsed)

    assert run(asked()) == ["overlay"]
    assert REHEARSED == []


LOADED_LATE = "sigcat.lsp.places"


def load_and_grow() -> int:
    importlib.import_module(LOADED_LATE)
    GROWN.append(bytes(range(256)) * (16 * MEBIBYTE // 256))
    return os.getpid()


GROWN: list[bytes] = []


def has_loaded() -> bool:
    return LOADED_LATE in sys.modules


def test_what_a_worker_loaded_that_ended_the_next_ones_have_from_the_start(queue: WorkQueue) -> None:
    assert not done(queue, has_loaded)
    process = done(queue, load_and_grow)
    wait_until(lambda: not is_running(process), "the process ends")
    assert done(queue, has_loaded)


def test_what_work_refuses_reaches_who_asked_for_it(queue: WorkQueue) -> None:
    with pytest.raises(InputRefused, match="Refused") as refused:
        done(queue, refuse)
    assert [(finding.rule, finding.line) for finding in refused.value.findings] == [("V001", 3)]


def test_a_fault_of_ours_says_where_it_is(queue: WorkQueue) -> None:
    with pytest.raises(RuntimeError, match="ValueError: invalid literal") as failed:
        done(queue, int, "x")
    assert "Traceback" in failed.value.__notes__[0]


@pytest.mark.parametrize("work", [time.sleep, stubborn])
def test_work_that_takes_too_long_is_ended(work: Callable[[object], None]) -> None:
    queue = WorkQueue(1, 0, seconds=DEADLINE)
    process = done(queue, os.getpid)
    queue._seconds = 0.1
    with pytest.raises(Busy, match=r"longer than 0\.1 seconds"):
        done(queue, work, DEADLINE)
    wait_until(lambda: not is_running(process), "the process ends")
    queue._seconds = DEADLINE
    assert done(queue, os.getpid) != process
    queue.close()


@pytest.mark.skipif(not Path("/proc/self/status").is_file(), reason="Linux, where the memory of a process is bounded")
def test_work_that_takes_too_much_memory_is_ended(queue: WorkQueue) -> None:
    process = done(queue, os.getpid)
    assert len(done(queue, bytes, 16 * MEBIBYTE)) == 16 * MEBIBYTE
    with pytest.raises(Busy, match="more than 32 MiB"):
        done(queue, bytes, 40 * MEBIBYTE)
    wait_until(lambda: not is_running(process), "the process ends")
    assert done(queue, len, b"next") == 4


def test_too_little_memory_for_an_error_of_its_own_is_too_little_memory(queue: WorkQueue) -> None:
    with pytest.raises(Busy, match="more than 32 MiB"):
        done(queue, fail_without_an_error)


def test_work_that_crashes_is_told_and_the_next_is_done(queue: WorkQueue) -> None:
    with pytest.raises(WorkFailed) as failed:
        done(queue, crash)
    assert failed.value.status_code == 500
    assert done(queue, len, b"next") == 4


def test_a_worker_that_somebody_killed_is_replaced(queue: WorkQueue) -> None:
    process = done(queue, os.getpid)
    os.kill(process, signal.SIGKILL)
    wait_until(lambda: not is_running(process), "it is killed")
    assert done(queue, len, b"next") == 4


@pytest.mark.skipif(not PROC.is_dir(), reason="Linux, which shows what is left of a process")
def test_nothing_is_left_of_a_worker_that_ended_whether_or_not_there_is_more_work(queue: WorkQueue) -> None:
    process = done(queue, os.getpid)
    os.kill(process, signal.SIGKILL)
    wait_until(lambda: not (PROC / str(process)).exists(), "the zygote reaps it")


def test_so_is_the_zygote(queue: WorkQueue) -> None:
    process = done(queue, os.getppid)
    os.kill(process, signal.SIGKILL)
    queue.close()
    wait_until(lambda: not is_running(process), "it is killed")
    assert done(queue, len, b"next") == 4


def test_work_is_given_up_with_who_asked_for_it(queue: WorkQueue, tmp_path: Path) -> None:
    async def impatient() -> None:
        task = asyncio.create_task(queue.of("a client").run(noted, tmp_path, "x"))
        await begun(tmp_path)
        task.cancel()

    process = done(queue, os.getpid)
    run(impatient())
    wait_until(lambda: not is_running(process), "the process ends")


def test_a_catalogue_arrives_as_it_was_asked_for(queue: WorkQueue, library: Library) -> None:
    for hosted in library:
        assert done(queue, digest_of, hosted.catalogue) == hosted.catalogue.digest
    folded = find_hosted(library, "small~folded").catalogue
    assert done(queue, instances_behind, folded) == instances_behind(folded)
    assert instances_behind(folded)[0] < instances_behind(folded)[1]


def test_a_catalogue_is_not_sent_with_the_work_but_named(library: Library) -> None:
    catalogue = library.default.catalogue
    folded = find_hosted(library, "small~folded").catalogue
    data, values = pickled(Work(zip, (catalogue, folded, catalogue), {}), lambda _: 7)
    assert (len(data) < 500, values) == (True, {7: catalogue})
    assert unpickled(io.BytesIO(data), {7: catalogue}).arguments == (catalogue, folded, catalogue)


def test_a_catalogue_that_nobody_holds_is_forgotten(queue: WorkQueue) -> None:
    catalogue = Library(SOURCES[:1]).default.catalogue
    done(queue, digest_of, catalogue)
    queue.close()
    before = done(queue, kept_in_worker)
    del catalogue
    gc.collect()
    queue.close()
    assert done(queue, kept_in_worker) < before


def test_a_worker_knows_nothing_that_was_told_after_it_was_forked(monkeypatch: pytest.MonkeyPatch) -> None:
    warm, fork = WarmZygote(), Zygote.child

    def told_meanwhile(zygote: Zygote, kind: str = "") -> socket.socket:
        connection = fork(zygote, kind)
        warm._tell((), {7: "told once the worker was forked"})
        return connection

    monkeypatch.setattr(Zygote, "child", told_meanwhile)
    connection, known = warm.child("")
    with connection:
        assert 7 not in known
    with warm.child("")[0]:
        assert 7 in warm.child("")[1]


def test_work_is_done_where_the_fork_server_ends_before_the_worker_is_forked(
    queue: WorkQueue, library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    fork = WarmZygote.child
    ended: list[int] = []

    def ended_once(warm: WarmZygote, kind: str) -> tuple[socket.socket, frozenset[int | str]]:
        if not ended and warm._last is not None:
            ended.append(warm._last.zygote._process.pid)
            os.kill(ended[0], signal.SIGKILL)
            wait_until(lambda: warm._last is None or warm._last.zygote.has_ended, "the fork server ends")
        return fork(warm, kind)

    monkeypatch.setattr(WarmZygote, "child", ended_once)
    assert done(queue, digest_of, library.default.catalogue) == library.default.catalogue.digest
    assert ended


def test_equal_work_under_way_is_done_once_for_all(queue: WorkQueue, tmp_path: Path) -> None:
    async def crowd() -> list[str]:
        asked = [
            asyncio.create_task(queue.of(client).run_once("key", noted, tmp_path, "x")) for client in ("a", "b", "c")
        ]
        await begun(tmp_path)
        asked[0].cancel()
        await asyncio.sleep(0)
        (tmp_path / "goes_on").touch()
        return await asyncio.gather(*asked[1:])

    assert run(crowd()) == ["x", "x"]
    assert (tmp_path / "notes").read_text() == "x"
    assert run(queue.of("d").run_once("key", noted, tmp_path, "y")) == "y"


def test_equal_work_ends_when_all_who_asked_for_it_went_away(queue: WorkQueue, tmp_path: Path) -> None:
    async def crowd() -> Any:
        asked = [
            asyncio.create_task(queue.of(client).run_once("key", noted, tmp_path, "x")) for client in ("a", "b", "c")
        ]
        await begun(tmp_path)
        for task in asked:
            assert queue.pending == 1
            task.cancel()
            await asyncio.sleep(0)
        return await queue.of("d").run_once("key", len, b"next")

    process = done(queue, os.getpid)
    assert run(crowd()) == 4
    wait_until(lambda: not is_running(process), "the process ends")


def test_health_answers_while_heavy_work_is_done(library: Library) -> None:
    app = create_app(library)

    async def both() -> int:
        work = asyncio.create_task(app.state.work_queue.of("a client").run(time.sleep, DEADLINE))
        async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://sigcat") as client:
            status = (await client.get("/health/live", timeout=DEADLINE)).status_code
        work.cancel()
        return status

    assert run(both()) == 200
