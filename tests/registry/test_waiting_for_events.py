"""Clients that wait for the next change of the registry over HTTP."""

import asyncio
import threading
import time
from pathlib import Path
from typing import Any

import httpx
import pytest

from sigcat.api.application import create_app
from sigcat.api.requests.thread_turns import THREADS
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library
from sigcat.limits import EVENT_WAITS
from sigcat.registry.publish import publish
from sigcat.registry.storing.ledger import Registry
from tests.api.conftest import SOURCES
from tests.registry.parts import candidate, catalogue, declaration
from tests.registry.served import asking, settings_of, signed_registry
from tests.waiting import DEADLINE

EVENTS = "/api/v1/registry/events"
NEW = candidate(declaration("Beta", (), ("S1",)), catalogue())


@pytest.fixture
def registry(tmp_path: Path) -> Registry:
    return signed_registry(tmp_path)


def test_events_are_answered_at_once_and_in_pages(registry: Registry) -> None:
    ask = asking(registry)
    first = ask(f"{EVENTS}?limit=3&wait=60").json()
    assert [each["type"].rpartition(".")[2] for each in first["registry_events"]] == ["published"] * 3
    rest = ask(f"{EVENTS}?after={first['epoch']}").json()
    assert [each["subject"] for each in rest["registry_events"]] == ["CoreAcc@1.0.0"]
    assert rest["registry_events"][0]["data"]["line"] == "SUV-2025"
    assert ask(f"{EVENTS}?after={rest['epoch']}").json() == {"registry_events": [], "epoch": rest["epoch"]}


def test_without_an_event_the_answer_is_empty_when_the_time_ends(registry: Registry) -> None:
    begun = time.monotonic()
    assert asking(registry)(f"{EVENTS}?after=4&wait=1").json() == {"registry_events": [], "epoch": 4}
    assert time.monotonic() - begun >= 1


def test_a_number_of_another_log_is_answered_with_the_last_one_of_this_one(registry: Registry) -> None:
    assert asking(registry)(f"{EVENTS}?after=99999&wait=60").json() == {"registry_events": [], "epoch": 4}


@pytest.mark.parametrize(
    "query", ["after=-1", "after=x", "wait=61", "wait=-1", "limit=0", "after=99999999999999999999"]
)
def test_a_request_that_does_not_fit_is_refused(registry: Registry, query: str) -> None:
    assert asking(registry)(f"{EVENTS}?{query}").status_code == 422


def application(registry: Registry) -> Any:
    return create_app(Library(SOURCES[:1]), Settings(client_share=1), registry=settings_of(registry))


async def waiting(app: Any, client: httpx.AsyncClient, count: int) -> "list[asyncio.Task[httpx.Response]]":
    """Requests that wait for an event."""
    tasks = [asyncio.create_task(client.get(f"{EVENTS}?after=4&wait=60")) for _ in range(count)]
    async with asyncio.timeout(DEADLINE):
        while app.state.event_turns.pending < count:  # noqa: ASYNC110 — the service has no event of it
            await asyncio.sleep(0.01)
    return tasks


def client_of(app: Any) -> httpx.AsyncClient:
    return httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://sigcat", timeout=60)


def run(coroutine: Any) -> None:
    with_loop = threading.Thread(target=asyncio.run, args=(coroutine,))  # a browser of other tests has this one's loop
    with_loop.start()
    with_loop.join()


def test_fifty_clients_that_wait_hold_no_thread_and_all_get_the_next_event(registry: Registry) -> None:
    found: list[httpx.Response] = []
    threads = 0

    async def scenario() -> None:
        nonlocal threads
        before = threading.active_count()
        app = application(registry)
        async with client_of(app) as client:
            tasks = await waiting(app, client, 50)
            threads = threading.active_count() - before
            found.append(await client.get("/api/v1/registry"))
            await asyncio.to_thread(publish, registry, [NEW])
            found.extend(await asyncio.wait_for(asyncio.gather(*tasks), 30))

    run(scenario())
    assert found[0].status_code == 200, "others are answered meanwhile"
    assert threads <= THREADS + 1
    assert [[each["subject"] for each in answer.json()["registry_events"]] for answer in found[1:]] == [
        ["Beta@1.0.0"]
    ] * 50


def test_more_than_a_bounded_number_are_refused(registry: Registry) -> None:
    refused: list[httpx.Response] = []

    async def scenario() -> None:
        app = application(registry)
        async with client_of(app) as client:
            app.state.event_turns._most = 2
            tasks = await waiting(app, client, 2)
            refused.append(await client.get(f"{EVENTS}?after=4&wait=60"))
            for task in tasks:
                task.cancel()

    run(scenario())
    assert refused[0].status_code in (429, 503)
    assert "Retry-After" in refused[0].headers
    assert EVENT_WAITS >= 50


def test_a_database_that_goes_away_ends_the_waiting(registry: Registry) -> None:
    found: list[httpx.Response] = []

    async def scenario() -> None:
        app = application(registry)
        async with client_of(app) as client:
            tasks = await waiting(app, client, 1)
            assert isinstance(registry.database, Path)
            registry.database.rename(registry.database.with_name("moved.db"))
            found.append(await asyncio.wait_for(tasks[0], 30))

    run(scenario())
    assert found[0].status_code == 503


def test_a_service_that_stops_answers_those_who_wait(registry: Registry) -> None:
    found: list[httpx.Response] = []

    async def scenario() -> None:
        app = application(registry)
        async with client_of(app) as client:
            tasks = await waiting(app, client, 1)
            app.state.event_watch.close()
            found.append(await asyncio.wait_for(tasks[0], 30))

    run(scenario())
    assert (found[0].status_code, found[0].json()["registry_events"]) == (200, [])
