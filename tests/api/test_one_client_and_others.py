"""Requests of one client change nothing for others: kept answers, counts, memory."""

import asyncio
import contextlib
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from inspect import iscoroutinefunction
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import httpx
import pytest
from fastapi import Request

from sigcat.api.answers import negotiation
from sigcat.api.answers.negotiation import accepts_gzip, liked_types
from sigcat.api.answers.schemas import RuleSummary
from sigcat.api.answers.serializers import rule_summary
from sigcat.api.application import create_app
from sigcat.api.requests.thread_turns import parts_in_turn
from sigcat.api.routes import contract, rules
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.catalogue.search import SearchIndex, SearchResult
from sigcat.limits import SEARCH_WORDS
from sigcat.rules.record import Rule
from sigcat.web.site import create_site
from tests import plain_http
from tests.api.conftest import SOURCES, Ask, asker
from tests.api.served_routes import served_routes
from tests.clients.generating import ROOT
from tests.waiting import DEADLINE, wait_until

SPEED = "/api/v1/catalogues/small/nodes/Vehicle.Speed"
LISTED = "/api/v1/catalogues/small/nodes?limit=3"
METADATA = "%7B%22type%22%3A%22static-metadata%22%2C%22parameter%22%3A%22%22%7D"
JSON, YAML, CSV = "application/json", "application/yaml", "text/csv"


@pytest.fixture
def fresh() -> Ask:
    """A service of which nothing is kept yet."""
    return asker(create_app(Library(SOURCES)))


@pytest.mark.parametrize("sent", [[JSON, CSV], [CSV, JSON], [f"{JSON};q=0.1", CSV], [f"{CSV};q=0", "*/*"]])
def test_what_is_kept_for_repeated_headers_is_given_to_nobody_who_asks_otherwise(fresh: Ask, sent: list[str]) -> None:
    fresh(LISTED, headers=[("Accept", each) for each in sent])
    for form in (JSON, YAML, CSV):
        assert fresh(LISTED, headers={"Accept": form}).headers["content-type"].startswith(form)


def test_repeated_headers_are_one_list(fresh: Ask) -> None:
    repeated = fresh(LISTED, headers=[("Accept", f"{JSON};q=0.5"), ("Accept", CSV)])
    assert repeated.headers["content-type"].startswith(CSV)
    etag = repeated.headers["etag"]
    assert fresh(LISTED, headers=[("If-None-Match", etag), ("If-None-Match", '"other"')]).status_code == 304


@pytest.mark.parametrize(
    ("sent", "packed"),
    [
        (["gzip"], True), (["identity", "gzip"], True), (["gzip", "identity"], True), (["gzip;q=0"], False), (["*"], True),
        (["*;q=0"], False), (["gzip;q=0", "*"], False), (["br"], False), (["x-gzip"], False), ([""], False),
    ],
)  # fmt: skip
def test_gzip_is_sent_to_those_who_allow_it_whoever_asked_before(fresh: Ask, sent: list[str], packed: bool) -> None:
    headers = [("Accept-Encoding", each) for each in sent]
    for before in ([("Accept-Encoding", "gzip")], [("Accept-Encoding", "identity")]):
        fresh(SPEED, headers=before)
        answer = fresh(SPEED, headers=headers)
        assert ("content-encoding" in answer.headers) == packed
        assert answer.json()["path"] == "Vehicle.Speed"


@pytest.mark.parametrize(
    ("accepted", "liked"),
    [
        ("*/*", (JSON, YAML, CSV)), ("text/*", (CSV,)), (f"{YAML}, {JSON};q=0.9", (YAML, JSON)), ("", (JSON, YAML, CSV)),
        (f"{JSON};q=0", ()), (f"{JSON};q=nan", (JSON,)), (f"{JSON};q=-1", (JSON,)), ("TEXT/CSV", (CSV,)), ("," * 5000, (JSON, YAML, CSV)),
    ],
)  # fmt: skip
def test_what_a_client_likes_is_read_as_rfc_9110_has_it(accepted: str, liked: tuple[str, ...]) -> None:
    assert liked_types(accepted) == liked


@pytest.mark.parametrize(("accepted", "allowed"), [("gzip;q=0.001", True), ("GZIP", True), ("gzip; q=0.000", False)])
def test_so_are_encodings(accepted: str, allowed: bool) -> None:
    assert accepts_gzip(accepted) == allowed


def test_invented_methods_are_one_in_the_metrics(fresh: Ask) -> None:
    for number in range(50):
        fresh(SPEED, f"INVENTED{number}")
        fresh(f"/{number}")
    counted = [line for line in fresh("/metrics").text.splitlines() if line.startswith("sigcat_requests_total")]
    assert "INVENTED" not in "".join(counted)
    assert len(counted) < 5


@pytest.mark.parametrize(
    "address",
    [SPEED, LISTED, "/api/v1/catalogues", "/api/v1/catalogues/small/tree", "/api/v1/rules", "/api/v1/schemas", "/health/live",
     "/api/v1/catalogues/small/units", "/api/v1/catalogues/bare/diff?to=small"],
)  # fmt: skip
def test_a_parameter_that_an_operation_does_not_have_is_refused(fresh: Ask, address: str) -> None:
    assert fresh(address).status_code == 200
    answer = fresh(address + ("&" if "?" in address else "?") + "colour=red&shape=")
    assert answer.status_code in (400, 422)
    assert "colour" in answer.json()["detail"]


@pytest.fixture
def sound(tmp_path: Path) -> Ask:
    """A service with a tree that can be exported."""
    (tmp_path / "tree.vspec").write_text("Vehicle: {type: branch, description: A vehicle.}\n")
    return asker(create_app(Library([Source("sound", "A sound tree", tmp_path / "tree.vspec")])))


def test_an_exporter_refuses_options_that_it_does_not_have(sound: Ask) -> None:
    assert sound("/api/v1/catalogues/sound/export/json").status_code == 200
    answer = sound("/api/v1/catalogues/sound/export/json?colour=red")
    assert answer.status_code == 422
    assert "colour" in answer.json()["detail"]


def test_of_answers_of_many_nodes_a_few_are_made_at_once(tmp_path: Path) -> None:
    signals = "".join(f"Vehicle.S{n}: {{type: sensor, datatype: float, description: X.}}\n" for n in range(1_000))
    (tmp_path / "tree.vspec").write_text("Vehicle: {type: branch, description: A vehicle.}\n" + signals)
    library = Library([Source("wide", "A wide tree", tmp_path / "tree.vspec")])
    app = create_site(library, Settings(long_answers=1, heavy_waiting=0, client_share=1))

    async def together(address: str) -> list[int]:
        transport = httpx.ASGITransport(app)
        async with httpx.AsyncClient(transport=transport, base_url="http://sigcat") as client:
            answers = await asyncio.gather(
                *(client.get(address) for _ in range(3)), client.get("/tree/wide/Vehicle.S1")
            )
        return [each.status_code for each in answers]

    with ThreadPoolExecutor(1) as thread:
        for address in (
            "/api/v1/catalogues/wide/tree",
            f"/api/v1/catalogues/wide/viss/Vehicle?filter={METADATA}",
            "/rows/wide?depth=2",
        ):
            found = thread.submit(asyncio.run, together(address)).result()
            assert sorted(found) == [200, 200, 503, 503], address


def test_a_head_of_an_export_runs_none(sound: Ask, fresh: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sigcat.api.routes.exports.exported", None)
    answer = sound("/api/v1/catalogues/sound/export/csv", "HEAD")
    assert (answer.status_code, answer.content) == (200, b"")
    assert answer.headers["content-type"].startswith("text/csv")
    assert answer.headers["etag"]
    assert "content-length" not in answer.headers, "it would be that of the export"
    assert fresh("/api/v1/catalogues/broken/export/csv", "HEAD").status_code == 422


@pytest.mark.parametrize("asked", ["nodes/Vehicle.Speed", "units", "tree", "export/csv", "export/json"])
def test_what_a_head_is_answered_with_is_given_to_nobody_who_wants_the_body(
    sound: Ask, fresh: Ask, monkeypatch: pytest.MonkeyPatch, asked: str
) -> None:
    ask = sound if asked.startswith("export") else fresh
    address = f"/api/v1/catalogues/{'sound' if ask is sound else 'small'}/{asked}"
    assert ask(address, "HEAD").content == b""
    assert ask(address).content


LONG = [
    *((f"/api/v1/{path}", form) for form in (YAML, CSV) for path in (
        "rules", "catalogues", "catalogues/small/nodes?limit=9", "catalogues/small/search?q=v", "catalogues/small/units",
        "catalogues/small/quantities",
    )),
    ("/api/v1/rules", JSON), ("/openapi.json", JSON),
]  # fmt: skip


@pytest.mark.parametrize(("address", "form"), LONG)
def test_what_takes_long_to_write_holds_up_nobody(
    fresh: Ask, monkeypatch: pytest.MonkeyPatch, address: str, form: str
) -> None:
    """It is written in a thread: forty clients that asked for all rules as YAML had all others wait for seconds."""
    written_by = []

    def noting(write: Callable[..., object], *arguments: object) -> object:
        written_by.append(threading.current_thread())
        return write(*arguments)

    for module, name in (
        (negotiation, "yaml_text"),
        (negotiation, "csv_text"),
        (negotiation, "json_bytes"),
        (contract, "json_bytes"),
    ):
        monkeypatch.setattr(module, name, partial(noting, getattr(module, name)))
    assert fresh(address, headers={"Accept": form}).status_code == 200
    assert {thread.name.startswith("AnyIO worker thread") for thread in written_by} == {True}


def test_what_threads_make_is_made_in_turns() -> None:
    """All functions of routes are coroutines: `InThread` makes one of those that are not, which waits for its turn."""
    found = served_routes()
    assert len(found) > 50
    assert [name for name, route in found.items() if not iscoroutinefunction(route.endpoint)] == []


@pytest.mark.parametrize("address", ["search?q=v", "nodes?q=v&instances=true", "nodes?q=v", "search?q=nothing"])
@pytest.mark.parametrize("form", [JSON, CSV])
def test_searches_run_in_threads(fresh: Ask, monkeypatch: pytest.MonkeyPatch, address: str, form: str) -> None:
    searched_by = []

    def noting(index: SearchIndex, *arguments: Any, **options: Any) -> SearchResult:
        searched_by.append(threading.current_thread().name)
        return search(index, *arguments, **options)

    search = SearchIndex.search
    monkeypatch.setattr(SearchIndex, "search", noting)
    assert fresh(f"/api/v1/catalogues/small/{address}", headers={"Accept": form}).status_code == 200
    assert [name.startswith("AnyIO worker thread") for name in searched_by] == [True]


def test_a_search_has_a_bounded_number_of_words(fresh: Ask) -> None:
    words, more = ("+".join("v" * number) for number in (SEARCH_WORDS, SEARCH_WORDS + 1))
    for operation in ("search", "nodes"):
        assert fresh(f"/api/v1/catalogues/small/{operation}?q={words}").status_code == 200
        refused = fresh(f"/api/v1/catalogues/small/{operation}?q={more}")
        assert (refused.status_code, f"at most {SEARCH_WORDS} words" in refused.json()["detail"]) == (422, True)


def test_one_client_does_not_keep_all_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    ending = threading.Event()

    def slow(rule: Rule) -> RuleSummary:
        assert ending.wait(DEADLINE)
        return rule_summary(rule)

    monkeypatch.setattr(rules, "rule_summary", slow)
    app = create_app(Library(SOURCES))

    async def crowd() -> int:
        def client(address: str) -> httpx.AsyncClient:
            return httpx.AsyncClient(transport=httpx.ASGITransport(app, client=(address, 1)), base_url="http://sigcat")

        async with client("192.0.2.1") as greedy, client("192.0.2.2") as modest:
            tasks = [asyncio.create_task(greedy.get("/api/v1/rules", timeout=DEADLINE)) for _ in range(20)]
            answer = await modest.get("/api/v1/rules/I201", timeout=DEADLINE)
            ending.set()
            assert {each.status_code for each in await asyncio.gather(*tasks)} == {200}
        return answer.status_code

    with ThreadPoolExecutor(1) as thread:
        assert thread.submit(asyncio.run, crowd()).result() == 200


def test_an_answer_goes_on_behind_a_part_that_is_empty() -> None:
    scope = {"type": "http", "app": create_app(Library(SOURCES)), "headers": [], "client": ("192.0.2.1", 1)}

    async def sent() -> list[bytes]:
        return [part async for part in parts_in_turn(Request(scope), iter((b"a", b"", b"b")))]

    with ThreadPoolExecutor(1) as thread:
        assert thread.submit(asyncio.run, sent()).result() == [b"a", b"", b"b"]


_SERVE = """
from sigcat.api.application import create_app
from sigcat.api.server import run
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Library
from tests.api.conftest import SOURCES
settings = Settings(port=0, body_seconds=60, bodies_bytes=8_000_000, body_bytes=4_000_000, log="none")
run(create_app(Library(SOURCES), settings), settings)
"""


@pytest.fixture
def address() -> Iterator[str]:
    """A service in a separate process, which holds few bytes of bodies."""
    command = [sys.executable, "-c", _SERVE]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().split()[3]
        process.kill()


@contextlib.contextmanager
def stalled(address: str, size: int) -> Iterator[None]:
    """A request of whose body the last byte does not come."""
    parts = urlsplit(address)
    head = f"POST /api/v1/lint HTTP/1.1\r\nHost: sigcat\r\nContent-Length: {size}\r\n\r\n".encode()
    with socket.create_connection((parts.hostname, parts.port), timeout=DEADLINE) as connection:
        connection.sendall(head + b" " * (size - 1))
        yield


def test_bodies_of_one_client_that_stall_are_bounded_and_given_back(address: str) -> None:
    def lint() -> httpx.Response:
        return plain_http.post(f"{address}/api/v1/lint", content=b"#" * 1_500_000)

    with stalled(address, 1_000_000), stalled(address, 1_000_000):
        wait_until(lambda: lint().status_code == 429, "the bytes that have arrived are counted")
        refused = lint()
        assert refused.headers["retry-after"]
        assert "bodies" in refused.json()["detail"]
        assert plain_http.get(f"{address}/health/live").status_code == 200
    wait_until(lambda: lint().status_code == 200, "the bytes of requests that are gone are given back")
