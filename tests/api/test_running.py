"""`sigcat serve` as a process: it finishes work in progress, logs, works behind a proxy, and streams."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from statistics import median
from urllib.parse import urlsplit

import httpx
import pytest

from sigcat.api.settings import Settings
from tests import plain_http
from tests.api.conftest import TREE
from tests.api.serving import Service, served
from tests.function.test_hosting import noise
from tests.processes import family, is_running
from tests.waiting import DEADLINE, wait_until

OVERLAY = b"Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n"


@pytest.fixture(scope="module")
def behind_a_proxy() -> Iterator[Service]:
    with served(TREE / "tree.vspec", SIGCAT_ROOT_PATH="/signals", SIGCAT_TRUSTED_PROXIES="127.0.0.1") as service:
        yield service


@contextmanager
def half_posted(service: Service) -> Iterator[socket.socket]:
    """A connection on which the service waits for the rest of an overlay."""
    parts = urlsplit(service.address)
    with socket.create_connection((parts.hostname, parts.port), timeout=DEADLINE) as connection:
        head = (
            f"POST /api/v1/lint HTTP/1.1\r\nHost: a\r\nContent-Length: {len(OVERLAY)}\r\nExpect: 100-continue\r\n\r\n"
        )
        connection.sendall(head.encode())
        assert connection.recv(65536).startswith(b"HTTP/1.1 100 ")
        connection.sendall(OVERLAY[:20])
        yield connection


def refuses_connections(service: Service) -> bool:
    parts = urlsplit(service.address)
    try:
        socket.create_connection((parts.hostname, parts.port), timeout=DEADLINE).close()
    except ConnectionRefusedError:
        return True
    return False


def test_what_is_under_way_is_finished_when_the_service_stops() -> None:
    with served(TREE / "tree.vspec") as service:
        with half_posted(service) as connection:
            service.process.send_signal(signal.SIGTERM)
            wait_until(lambda: refuses_connections(service), "the service takes nothing new")
            connection.sendall(OVERLAY[20:])
            assert connection.recv(65536).startswith(b"HTTP/1.1 200 ")
        assert service.process.wait(DEADLINE) in (0, -signal.SIGTERM)


def test_who_waits_longer_than_the_service_takes_to_stop_is_told_to_come_again() -> None:
    with served(TREE / "tree.vspec", SIGCAT_STOP_SECONDS="1") as service:
        with half_posted(service) as connection:
            service.process.send_signal(signal.SIGTERM)
            answer = connection.recv(65536)
        assert answer.startswith(b"HTTP/1.1 503 ")
        assert b"retry-after: 2" in answer.lower()
        assert "Traceback" not in service.log.read_text()


def workers_below(folder: Path) -> list[str]:
    """Processes that work in a folder below this one."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            found += [process.name] if str((process / "cwd").readlink()).startswith(str(folder)) else []
    return found


@pytest.mark.skipif(not Path("/proc/self/cwd").exists(), reason="Linux, where processes are found in /proc")
def test_an_export_ends_with_the_service_and_leaves_nothing(tmp_path: Path) -> None:
    with served(TREE / "tree.vspec", TMPDIR=str(tmp_path)) as service:
        parts = urlsplit(service.address)
        with socket.create_connection((parts.hostname, parts.port), timeout=DEADLINE) as connection:
            connection.sendall(b"GET /api/v1/catalogues/interfaces/export/id HTTP/1.1\r\nHost: a\r\n\r\n")
            wait_until(lambda: workers_below(tmp_path), "an export has its process")
            service.process.kill()
            wait_until(lambda: not list(tmp_path.glob("sigcat-export-*")), "the export leaves nothing")
            wait_until(lambda: not workers_below(tmp_path), "its process ends")


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="Linux, where processes are found in /proc")
@pytest.mark.parametrize("ended_by", [signal.SIGTERM, signal.SIGKILL])
def test_no_process_survives_the_service(ended_by: signal.Signals) -> None:
    with served(TREE / "tree.vspec") as service:
        lint = partial(plain_http.post, f"{service.address}/api/v1/lint", content=OVERLAY)
        assert lint().status_code == 200
        processes = family(service.process.pid)
        assert len(processes) >= 3, "the service, its zygote, and a worker"
        service.process.send_signal(ended_by)
        wait_until(lambda: not any(map(is_running, processes)), "all end")


def test_a_port_that_is_taken_is_said_and_ends_with_2() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        command = [sys.executable, "-m", "sigcat.cli", "serve", "--port", str(taken.getsockname()[1])]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert ended.returncode == 2
    assert "in use. Choose another with --port" in ended.stderr
    assert "{" not in ended.stderr


def test_as_an_application_of_another_server_it_logs_and_watches_too(tmp_path: Path) -> None:
    tree, settings = tmp_path / "tree.vspec", tmp_path / "sigcat.toml"
    signal = "Vehicle.Mass: {type: attribute, datatype: float, description: Its mass.}\n"
    tree.write_text("Vehicle: {type: branch, description: A vehicle.}\n" + signal)
    settings.write_text('watch = true\n[[catalogue]]\nid = "own"\ntitle = "Own"\nspec = "tree.vspec"\n')
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    command = [sys.executable, "-m", "uvicorn", "--factory", "sigcat.cli.serve:application", "--port", str(port)]
    command += ["--http", "sigcat.api.connections.http:HttpConnection"]
    environment = {**os.environ, "SIGCAT_CONFIG": str(settings)}
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=environment) as process:
        try:
            wait_until(lambda: nodes_at(port) == 2, "the catalogue is served")
            tree.write_text(tree.read_text() + OVERLAY.decode())
            wait_until(lambda: nodes_at(port) == 3, "the changed catalogue is served")
            assert "\nsigcat_connections 1.0" in plain_http.get(f"http://127.0.0.1:{port}/metrics").text
        finally:
            process.terminate()
            assert process.stderr is not None
            lines = [json.loads(line) for line in process.stderr if line.startswith("{")]
    assert any(line.get("route") == "/api/v1/catalogues/{catalogue}" for line in lines)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A project file with a catalogue, and what it can name more."""
    (tmp_path / "tree.vspec").write_text(f"Vehicle: {{type: branch, description: A vehicle.}}\n{OVERLAY.decode()}")
    (tmp_path / "overlay.vspec").write_text(
        "Vehicle.Drag: {type: sensor, datatype: float, unit: zorp, description: Drag.}\n"
    )
    (tmp_path / "units.yaml").write_text(
        "zorp: {definition: Drag., unit: Zorp, quantity: drag, allowed-datatypes: [float]}\n"
    )
    (tmp_path / "quantities.yaml").write_text("drag: {definition: Drag.}\n")
    (tmp_path / "functions").mkdir()
    (tmp_path / "functions/near.function.yaml").write_text(noise("Near"))
    (tmp_path / "sigcat.toml").write_text(PROJECT)
    return tmp_path / "sigcat.toml"


PROJECT = 'watch = true\n[[catalogue]]\nid = "own"\ntitle = "Own"\nspec = "tree.vspec"\n'


@contextmanager
def serving(project: Path) -> Iterator[tuple[str, Path]]:
    """Address and log of a service over a project."""
    command = [sys.executable, "-m", "sigcat.cli", "serve", "--port", "0", "--config", str(project)]
    log = project.with_name("log")
    with (
        log.open("w") as out,
        subprocess.Popen(command, stdout=subprocess.PIPE, stderr=out, text=True) as process,
    ):
        assert process.stdout is not None
        try:
            yield process.stdout.readline().split()[3], log
        finally:
            process.kill()


def test_a_changed_project_file_is_taken_over_while_the_service_runs(project: Path) -> None:
    with serving(project) as (address, log):
        catalogue = partial(plain_http.get, f"{address}/api/v1/catalogues/own")
        assert catalogue().json()["node_count"] == 2
        project.write_text(
            'functions = ["functions"]\nunits = ["units.yaml"]\nquantities = ["quantities.yaml"]\n'
            f'{PROJECT}overlays = ["overlay.vspec"]\n[service]\nport = 1\n'
            '[[catalogue]]\nid = "more"\ntitle = "More"\nspec = "tree.vspec"\n'
        )
        wait_until(lambda: catalogue().json()["node_count"] == 3, "the overlay and its unit are read")
        assert catalogue().json()["rejected"] == []
        assert plain_http.get(f"{address}/api/v1/catalogues/more").json()["node_count"] == 2
        near = partial(plain_http.get, f"{address}/functions/near")
        wait_until(lambda: near().status_code == 200, "the function is hosted")
        wait_until(lambda: "start the service again to use service" in log.read_text(), "a key needs a new start")
        project.write_text(PROJECT)
        wait_until(lambda: near().status_code == 404, "the function is gone")
        assert catalogue().json()["node_count"] == 2
        assert plain_http.get(f"{address}/api/v1/catalogues/more").status_code == 404


def test_an_invalid_project_file_is_shown_and_the_last_good_state_stays(project: Path) -> None:
    with serving(project) as (address, log):
        catalogue = partial(plain_http.get, f"{address}/api/v1/catalogues/own")
        project.write_text(PROJECT.replace("spec", "spce"))
        wait_until(lambda: catalogue().json()["rejected"], "the finding is shown")
        state = catalogue().json()
        assert state["node_count"] == 2
        assert {(each["rule"], each["file"]) for each in state["rejected"]} >= {("C002", str(project))}
        assert "catalogue own" in plain_http.get(f"{address}/health/ready").json()["outdated"]
        assert "spce" in plain_http.get(f"{address}/catalogues/own").text
        project.write_text(PROJECT)
        wait_until(lambda: not catalogue().json()["rejected"], "it is taken back")
        assert "Traceback" not in log.read_text()


def nodes_at(port: int) -> int:
    """Nodes of the catalogue; none while the service does not answer."""
    with suppress(httpx.TransportError):
        return int(plain_http.get(f"http://127.0.0.1:{port}/api/v1/catalogues/own").json()["node_count"])
    return 0


def test_each_request_is_a_line_of_json_with_the_id_that_its_problem_carries(behind_a_proxy: Service) -> None:
    answer = plain_http.get(f"{behind_a_proxy.address}/api/v1/catalogues/local/nodes/Nothing")
    lines = behind_a_proxy.logged(request_id=answer.json()["request_id"])
    assert [(line["status"], line["method"], line["level"]) for line in lines] == [(404, "GET", "info")]


def test_the_client_that_a_trusted_proxy_names_is_the_one_that_is_logged(behind_a_proxy: Service) -> None:
    headers = {"X-Forwarded-For": "203.0.113.9", "X-Forwarded-Proto": "https", "X-Request-Id": "from-the-proxy"}
    plain_http.get(f"{behind_a_proxy.address}/api/v1/catalogues", headers=headers)
    (line,) = behind_a_proxy.logged(request_id="from-the-proxy")
    assert line["client"] == "203.0.113.9"


def test_a_client_that_nobody_trusts_cannot_name_another() -> None:
    with served(TREE / "tree.vspec") as service:
        plain_http.get(f"{service.address}/health/live", headers={"X-Forwarded-For": "203.0.113.9"})
        assert {line["client"] for line in service.logged(path="/health/live")} == {"127.0.0.1"}


def test_pages_document_and_links_stand_below_the_path_that_a_proxy_offers(behind_a_proxy: Service) -> None:
    for page in ("/tree/local/Vehicle.Speed", "/docs", "/search/local?q=speed"):
        text = plain_http.get(behind_a_proxy.address + page).text
        links = [part.partition('"')[0] for part in text.split('href="')[1:]]
        assert any(link.startswith("/signals/") for link in links), page
        assert not [link for link in links if link.startswith("/") and not link.startswith("/signals")], page
    document = plain_http.get(f"{behind_a_proxy.address}/openapi.json").json()
    assert document["servers"][0]["url"] == "/signals"
    schemas = plain_http.get(f"{behind_a_proxy.address}/api/v1/schemas").json()["schemas"]
    assert all(address.startswith("/signals/api/v1/") for address in schemas)
    assert "/signals/static/sigcat.css" in plain_http.get(f"{behind_a_proxy.address}/static/nope").text


TREE_OF_30000 = """
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Part: {type: branch, description: A part., instances: 'Number[1,1000]'}
""" + "".join(
    f"Vehicle.Part.S{n}: {{type: sensor, datatype: float, description: Signal number {n} of a large tree.}}\n"
    for n in range(30)
)


@pytest.fixture(scope="module")
def large(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Service]:
    tree = tmp_path_factory.mktemp("large") / "large.vspec"
    tree.write_text(TREE_OF_30000)
    with served(tree, SIGCAT_LOG="none") as service:
        yield service


@pytest.mark.skipif(
    not Path("/proc/self/statm").is_file(), reason="Linux, where the memory of a process is read from /proc"
)
@pytest.mark.parametrize(
    ("path", "accepted"),
    [("export/json", "*/*"), ("nodes?fields=path,datatype,description", "text/csv"), ("nodes?q=number", "text/csv")],
)
def test_a_long_answer_begins_at_once_and_takes_no_memory(large: Service, path: str, accepted: str) -> None:
    request = urllib.request.Request(
        f"{large.address}/api/v1/catalogues/local/{path}", headers={"Accept": accepted, "Accept-Encoding": "identity"}
    )
    urllib.request.urlopen(request).read()
    before = large.memory
    parts, sizes = zip(*(part_until_the_first_byte(request) for _ in range(3)), strict=True)
    assert median(parts) < 1 / 2
    assert large.memory - before < max(sizes) / 2 + 1_000_000


def part_until_the_first_byte(request: urllib.request.Request) -> tuple[float, int]:
    """The part of the time of an answer that passes before it begins, and its bytes."""
    start = time.perf_counter()
    with urllib.request.urlopen(request) as answer:
        assert answer.headers["Transfer-Encoding"] == "chunked"
        assert answer.read(1)
        first = time.perf_counter() - start
        size = 1 + len(answer.read())
    return first / (time.perf_counter() - start), size


def test_settings_of_the_environment_are_those_that_the_command_prints() -> None:
    command = [sys.executable, "-m", "sigcat.cli", "config"]
    printed = subprocess.run(
        command, env={**os.environ, "SIGCAT_VALUES": "5000"}, capture_output=True, text=True, check=True
    )
    assert "values = 5000" in printed.stdout
    assert all(f"\n{name} = " in printed.stdout for name in Settings.model_fields)
    misspelled = {**os.environ, "SIGCAT_VALEUS": "1"}
    refused = subprocess.run(command, env=misspelled, capture_output=True, text=True, check=False)
    assert refused.returncode == 2
    assert "SIGCAT_VALUES" in refused.stderr
