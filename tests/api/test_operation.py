"""Running the service: request ids, metrics, logs, closed reading, CORS, compression, kept answers, a full queue."""

import asyncio
import io
import json
import threading
from pathlib import Path

import pytest

from sigcat.api.application import create_app
from sigcat.api.middleware.answer_cache import AnswerCache
from sigcat.api.middleware.request_notes import Note
from sigcat.api.read_settings import read_settings, shown
from sigcat.api.request_lines import RequestLines, line_of
from sigcat.api.server import uvicorn_config
from sigcat.api.settings import Settings
from sigcat.api.tokens import new_token
from sigcat.catalogue.hosting.library import Library, Source
from sigcat.errors import InputRefused
from tests.api.conftest import Ask, asker

SMALL = "/api/v1/catalogues/small"
SECRET, TOKEN = new_token("reader", ["read"])


def test_a_problem_carries_the_id_of_the_request(ask: Ask) -> None:
    answer = ask(f"{SMALL}/nodes/Nothing")
    assert answer.json()["request_id"] == answer.headers["x-request-id"]
    assert ask(SMALL).headers["x-request-id"] != answer.headers["x-request-id"]


def test_the_id_that_a_proxy_gave_is_kept_if_it_looks_like_one(ask: Ask) -> None:
    assert ask(SMALL, headers={"X-Request-Id": "from-proxy-1"}).headers["x-request-id"] == "from-proxy-1"
    assert ask(SMALL, headers={"X-Request-Id": '"} evil'}).headers["x-request-id"] != '"} evil'


def test_metrics_count_by_route_and_not_by_address(library: Library) -> None:
    ask = asker(create_app(library))
    for path in ("Vehicle.Speed", "Vehicle.Door", "Nothing"):
        ask(f"{SMALL}/nodes/{path}")
    ask("/wp-login.php")
    text = ask("/metrics").text
    route = "/api/v1/catalogues/{catalogue}/nodes/{path}"
    assert f'sigcat_requests_total{{method="GET",route="{route}",status="200"}} 2.0' in text
    assert f'sigcat_request_seconds_count{{route="{route}"}} 3.0' in text
    assert 'route="(none)",status="404"' in text
    assert "wp-login" not in text
    assert 'sigcat_catalogue_nodes{catalogue="small"' in text


def test_metrics_tell_of_errors_and_of_exports_that_wait(library: Library) -> None:
    text = asker(create_app(library))("/metrics").text
    assert 'sigcat_catalogue_errors{catalogue="broken"} 1.0' in text
    assert "sigcat_exports_pending 0.0" in text


def test_head_is_get_without_the_body(ask: Ask) -> None:
    for path in ("nodes/Vehicle.Speed", "nodes?limit=2", "export/json", "nodes/Nothing"):
        head, get = (ask(f"{SMALL}/{path}", method) for method in ("HEAD", "GET"))
        kept = {"etag", "content-type", "cache-control"}
        assert (head.status_code, head.content) == (get.status_code, b"")
        assert {k: v for k, v in head.headers.items() if k in kept} == {
            k: v for k, v in get.headers.items() if k in kept
        }


def test_metrics_can_be_turned_off(library: Library) -> None:
    assert asker(create_app(library, Settings(metrics=False)))("/metrics").status_code == 404


@pytest.fixture
def notes() -> list[Note]:
    return []


@pytest.fixture
def noted(library: Library, notes: list[Note]) -> Ask:
    """A service that logs into `notes`."""
    app = create_app(library)
    app.state.request_notes.log = notes.append
    return asker(app)


def test_a_request_is_one_line_of_json_in_the_log(noted: Ask, notes: list[Note]) -> None:
    answer = noted(f"{SMALL}/nodes/Vehicle.Speed%0Aforged")
    (line,) = [line_of(0, note) for note in notes]
    assert line.endswith("\n")
    assert line.count("\n") == 1
    record = json.loads(line)
    assert record["request_id"] == answer.headers["x-request-id"]
    assert (record["status"], record["route"]) == (404, "/api/v1/catalogues/{catalogue}/nodes/{path}")


def test_lines_are_written_in_order_and_all_of_them_before_the_end() -> None:
    stream = io.StringIO()
    lines = RequestLines(stream)
    for number in range(1000):
        lines.add(Note(str(number), "GET", "/", "/", 200, 0, ""))
    lines.end()
    assert [json.loads(line)["request_id"] for line in stream.getvalue().splitlines()] == [str(n) for n in range(1000)]


def test_a_log_that_nobody_reads_holds_up_no_answer_and_grows_no_further() -> None:
    blocked = threading.Event()

    class Stream(io.StringIO):
        def write(self, text: str) -> int:
            blocked.wait()
            return super().write(text)

    stream = Stream()
    lines = RequestLines(stream)
    for number in range(50_000):
        lines.add(Note(str(number), "GET", "/", "/", 200, 0, ""))
    blocked.set()
    lines.end()
    written = stream.getvalue().splitlines()
    assert json.loads(written[-1])["request_id"] == "49999"
    assert len(written) < 50_000


@pytest.fixture
def closed(library: Library) -> Ask:
    return asker(create_app(library, Settings(reading="token", tokens=(TOKEN,))))


def test_no_shared_cache_keeps_what_is_closed(closed: Ask, ask: Ask) -> None:
    headers = {"Authorization": f"Bearer {SECRET}"}
    version = closed(SMALL, headers=headers).json()["version"]
    fixed = f"{SMALL}@{version}/nodes/Vehicle.Speed"
    assert closed(fixed, headers=headers).headers["cache-control"] == "private, max-age=31536000, immutable"
    assert closed(SMALL, headers=headers).headers["cache-control"] == "private, no-cache"
    assert ask(fixed).headers["cache-control"] == "public, max-age=31536000, immutable"


def test_a_page_of_an_allowed_origin_can_read_that_it_needs_a_token(library: Library) -> None:
    app = create_app(library, Settings(reading="token", tokens=(TOKEN,), origins=("https://a.example",)))
    refused = asker(app)(SMALL, headers={"Origin": "https://a.example"})
    assert (refused.status_code, refused.headers["access-control-allow-origin"]) == (401, "https://a.example")


def test_reading_can_be_closed(closed: Ask) -> None:
    refused = closed(SMALL)
    assert refused.status_code == 401
    assert refused.json()["type"] == "/problems/unauthorized"
    assert closed(SMALL, headers={"Authorization": f"Bearer {SECRET}"}).status_code == 200
    assert closed("/openapi.json").status_code == 401
    assert closed("/health/ready").status_code == 200


def test_a_kept_answer_is_not_given_to_one_without_a_token(closed: Ask) -> None:
    for _ in range(2):
        assert closed(f"{SMALL}/units", headers={"Authorization": f"Bearer {SECRET}"}).status_code == 200
    assert closed(f"{SMALL}/units").status_code == 401


def test_pages_of_other_origins_may_call_only_if_they_are_named(library: Library) -> None:
    origin = {"Origin": "https://tools.example"}
    open_to_it = asker(create_app(library, Settings(origins=("https://tools.example",))))
    assert open_to_it(SMALL, headers=origin).headers["access-control-allow-origin"] == "https://tools.example"
    assert "access-control-allow-origin" not in asker(create_app(library))(SMALL, headers=origin).headers


def test_long_answers_are_compressed_for_who_can_read_them(ask: Ask) -> None:
    packed = ask(f"{SMALL}/nodes/Vehicle.Speed")
    assert packed.headers["content-encoding"] == "gzip"
    assert "Accept-Encoding" in packed.headers["vary"]
    plain = ask(f"{SMALL}/nodes/Vehicle.Speed", headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.headers
    assert plain.json() == packed.json()


def test_a_kept_answer_is_the_same_answer(library: Library) -> None:
    ask = asker(create_app(library))
    first, second = ask(f"{SMALL}/nodes/Vehicle.Speed"), ask(f"{SMALL}/nodes/Vehicle.Speed")
    assert second.content == first.content
    drop = {"x-request-id"}
    assert {k: v for k, v in second.headers.items() if k not in drop} == {
        k: v for k, v in first.headers.items() if k not in drop
    }
    yaml = ask(f"{SMALL}/nodes/Vehicle.Speed", headers={"Accept": "application/yaml"})
    assert yaml.headers["content-type"] == "application/yaml"
    held = ask(f"{SMALL}/nodes/Vehicle.Speed", headers={"If-None-Match": first.headers["etag"]})
    assert (held.status_code, held.content, held.headers["etag"]) == (304, b"", first.headers["etag"])


def test_a_kept_answer_is_forgotten_when_its_catalogue_changes(tmp_path: Path) -> None:
    tree = tmp_path / "tree.vspec"
    tree.write_text("Vehicle: {type: branch, description: Before.}")
    library = Library([Source("mine", "Mine", tree)])
    ask = asker(create_app(library))
    address = "/api/v1/catalogues/mine/tree"
    before = [ask(address).json()["description"] for _ in range(2)]
    tree.write_text("Vehicle: {type: branch, description: Afterwards.}")
    library.reload("mine")
    assert [*before, ask(address).json()["description"]] == ["Before.", "Before.", "Afterwards."]


def test_the_cache_stays_within_its_bound(library: Library) -> None:
    cache = AnswerCache(create_app(library, Settings(cache_bytes=0)), library, most_bytes=5_000)
    ask = asker(cache)
    paths = list(library.get("small").catalogue.nodes)
    sizes = [len(ask(f"{SMALL}/nodes/{path}").content) for path in paths]
    assert sum(sizes) > 10_000
    assert 0 < sum(len(answer.body["body"]) for answer in cache._cached.values()) <= 5_000
    assert [ask(f"{SMALL}/nodes/{path}").json()["path"] for path in paths] == paths


def test_a_body_that_does_not_arrive_is_given_up(library: Library) -> None:
    async def drip() -> object:
        yield b"Vehicle"
        await asyncio.Event().wait()

    ask = asker(create_app(library, Settings(body_seconds=0.05)))
    late = ask("/api/v1/lint", "POST", content=drip())
    assert late.status_code == 408
    assert late.json()["type"] == "/problems/request-timeout"


def test_settings_come_from_the_file_and_over_it_from_the_environment() -> None:
    settings = read_settings({"results": 7, "origins": ["https://a"]}, {"SIGCAT_RESULTS": "9", "SIGCAT_PORT": "81"})
    assert (settings.results, settings.port, settings.origins) == (9, 81, ("https://a",))
    listed = read_settings({}, {"SIGCAT_TRUSTED_PROXIES": "10.0.0.1, 10.0.0.2", "SIGCAT_TOKENS": str(TOKEN)})
    assert (listed.trusted_proxies, listed.tokens) == (("10.0.0.1", "10.0.0.2"), (TOKEN,))


@pytest.mark.parametrize(
    ("table", "environment", "expected"),
    [
        ({"resluts": 7}, {}, "Did you mean"),
        ({}, {"SIGCAT_RESLUTS": "7"}, "SIGCAT_RESULTS"),
        ({"results": 0}, {}, "[service] results"),
        ({}, {"SIGCAT_PORT": "many"}, "SIGCAT_PORT"),
        ({}, {"SIGCAT_PORT": "tcp://10.0.0.1:8000"}, "enableServiceLinks"),
        ({}, {"SIGCAT_SERVICE_HOST": "10.0.0.1"}, "enableServiceLinks"),
        ({"tokens": ["secret-in-the-wrong-place"]}, {}, "NAME:SCOPE"),
        ({"reading": "closed"}, {}, "'open' or 'token'"),
    ],
)
def test_settings_that_do_not_fit_are_refused(
    table: dict[str, object], environment: dict[str, str], expected: str
) -> None:
    with pytest.raises(InputRefused) as refused:
        read_settings(table, environment)
    text = " ".join(finding.line_of_text for finding in refused.value.findings)
    assert expected in text
    assert "secret" not in text


def test_every_setting_is_described() -> None:
    settings = {name: description for name, _, description in shown(Settings())}
    assert settings.keys() == set(Settings.model_fields)
    assert all(settings.values())


def test_a_proxy_is_believed_only_if_it_is_trusted(library: Library) -> None:
    app = create_app(library)
    assert not uvicorn_config(app, Settings()).proxy_headers
    trusting = uvicorn_config(app, Settings(trusted_proxies=("10.0.0.1",), root_path="/sigcat"))
    assert (trusting.proxy_headers, trusting.forwarded_allow_ips, trusting.root_path) == (True, ["10.0.0.1"], "/sigcat")
