"""The commands with a service give the same output and the same exit status as with a database."""

import json
import os
import re
import shlex
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import IO, NamedTuple

import pytest

from sigcat.cli import main
from sigcat.registry.storing.database import reading, writing
from sigcat.registry.storing.ledger import head, log_page
from sigcat.registry.storing.signing import new_key
from sigcat.registry.storing.tokens import create_token
from sigcat.registry.storing.verify import verify
from tests.registry.served import CONTENT, OVERLAY, TREE, function_file

PROJECT = '[[catalogue]]\nid = "fleet"\nspec = "tree.vspec"\noverlays = ["signals.vspec"]\n'
DATABASE = f'[registry]\ndatabase = "registry.db"\nkey = "registry.key"\n{PROJECT}'
LOST = function_file("CoreAcc", "{path: Vehicle.S1, role: consumed}", "2.0.0")
FILES = {
    "CoreAcc.yaml": CONTENT,
    "User.yaml": function_file("User", "{path: Vehicle.S0, role: consumed}"),
    "Provider.yaml": function_file("Provider", "{path: Vehicle.S1, role: provided}"),
    "Lost.yaml": LOST,
    "Unprovider.yaml": function_file("Provider", "{path: Vehicle.S0, role: consumed}", "1.1.0"),
    "Other.yaml": CONTENT.replace(b"An example", b"Another one"),
    "Wrong.yaml": CONTENT.replace(b"Vehicle.S0", b"Vehicle.S9"),
    "Below.yaml": function_file("Below", "{path: Vehicle.Low.Level, role: consumed}"),
    "below.vspec": b"Vehicle.Low: {type: branch, description: Low.}\n"
    b"Vehicle.Low.Level: {type: sensor, datatype: float, description: A level.}\n",
    "above.vspec": b"Vehicle.Low.Level: {max: 5}\n",
    "smaller.vspec": TREE.encode().partition(b"Vehicle.S1:")[0],
    "broken.vspec": b"Vehicle: {type: branch, description: A vehicle.}\nVehicle.A.B: {type: branch, description: B.}\n",
    "signals.vspec": OVERLAY.encode(),
    "tree.vspec": TREE.encode(),
}
STEPS = (
    "publish CoreAcc.yaml User.yaml Provider.yaml",
    "publish signals.vspec --version 1.0.0 --owner Platform",
    "publish signals.vspec",
    "publish CoreAcc.yaml",
    "publish Other.yaml",
    "publish Wrong.yaml",
    "publish CoreAcc.yaml --version 3.0.0",
    "publish tree.vspec",
    "publish tree.vspec --version 1.0.0 --owner Platform",
    "publish tree.vspec --version 1.0.0 --owner Platform",
    "registry show fleet@1.0.0 --kind catalogue",
    "check tree.vspec",
    "check smaller.vspec",
    "publish broken.vspec --version 1.0.0",
    "publish Below.yaml",
    "publish Below.yaml below.vspec --version 1.0.0 --owner Platform",
    "publish above.vspec below.vspec --version 2.0.0",
    "check Below.yaml below.vspec above.vspec",
    "registry list",
    "registry list --kind overlay",
    "registry record-deployment SUV-2025 CoreAcc@1.0.0",
    "registry record-deployment SUV-2025 User@1.0.0",
    "registry record-deployment SUV-2025 Provider@1.0.0",
    "registry record-deployment SUV-2025 Usr@1.0.0",
    "registry record-release a/b User@1.0.0",
    "registry list --line SUV-2025",
    "registry list --line SUV-2025 --kind overlay",
    "users Vehicle.S0",
    "users Vehicle.S0 --all --format json",
    "users Vehicle.S8",
    "check Lost.yaml",
    "check Lost.yaml --format github",
    "check CoreAcc.yaml",
    "check Wrong.yaml",
    "publish Lost.yaml --draft",
    "publish Lost.yaml",
    "can-i-deploy CoreAcc@2.0.0 --to SUV-2025",
    "can-i-deploy CoreAcc@2.0.0 --to SUV-2025 --format json",
    "can-i-deploy CoreAcc@2.0.0 --to SUV-2026",
    "can-i-deploy CoreAcc@2.0.0 --to SUV-2025 --with Provider@1.0.0",
    "can-i-deploy CoreAcc --to SUV-2025",
    "registry deprecate CoreAcc@1.0.0 --until 2040-12-31 --successor 2.0.0",
    "registry deprecations",
    "registry acknowledge CoreAcc@1.0.0 --owner 'Team User'",
    "registry acknowledge CoreAcc@1.0.0 --owner Nobody",
    "registry deprecations --owner 'Team User'",
    "registry deprecations",
    "registry retire CoreAcc@1.0.0",
    "registry support-ended SUV-2025 CoreAcc@1.0.0",
    "registry retire CoreAcc@1.0.0",
    "registry rule CoreAcc full",
    "registry rule Provider approval",
    "publish Unprovider.yaml",
    "registry pending",
    "registry pending --owner Nobody",
    "registry reject Provider@1.1.0 --owner 'Team Provider' --reason late",
    "registry reject Provider@1.1.0 --owner 'Team CoreAcc' --reason S1_is_needed",
    "registry approve Provider@1.1.0 --owner 'Team CoreAcc' --sha256 00",
    "registry approve Provider@1.1.0 --owner 'Team CoreAcc' --valid-for 0",
    "registry approve Provider@1.1.0 --owner 'Team CoreAcc'",
    "registry pending",
    "publish Unprovider.yaml",
    "registry pending",
    "registry show CoreAcc@2.0.0",
    "registry show CoreAcc@2.0.0 --resolved",
    "registry list",
)  # fmt: skip


class Served(NamedTuple):
    """A running service."""

    address: str
    process: "subprocess.Popen[str]"
    folder: Path


def write(folder: Path, project: str) -> None:
    for name, content in FILES.items():
        (folder / name).write_bytes(content)
    (folder / "sigcat.toml").write_text(project, encoding="utf-8")


@contextmanager
def serving(folder: Path, port: str = "0", before: Sequence[str] = ()) -> Iterator[Served]:
    """A service of the project in a folder, started by words `before` its command."""
    command = [*before, sys.executable, "-m", "sigcat.cli", "serve", "--port", port]
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        assert process.stdout is not None
        try:
            yield Served(process.stdout.readline().split()[3], process, folder)
        finally:
            process.kill()


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("served")
    write(folder, DATABASE)
    (folder / "registry.key").write_bytes(new_key()[0])
    with serving(folder) as service:
        yield service


Run = Callable[[Path, str], tuple[int, str, str]]


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run a command in a folder: its status, output, and errors."""

    def command(folder: Path, words: str) -> tuple[int, str, str]:
        monkeypatch.chdir(folder)
        status = main(shlex.split(words))
        printed = capsys.readouterr()
        return status, printed.out, re.sub(r"head of the log: [0-9a-f]{64}", "head of the log", printed.err)

    return command


def client_of(served: Served, folder: Path) -> Path:
    """A project whose registry is that of a service."""
    folder.mkdir()
    write(folder, f'[registry]\nserver = "{served.address}"\n{PROJECT}')
    return folder


def test_every_step_gives_the_same_with_a_service_and_with_a_database(served: Served, run: Run, tmp_path: Path) -> None:
    local = tmp_path / "local"
    local.mkdir()
    write(local, DATABASE)
    (local / "registry.key").write_bytes(new_key()[0])
    remote = client_of(served, tmp_path / "remote")
    for words in STEPS:
        ours, theirs = run(local, words), run(remote, words)
        assert (theirs[0], theirs[1]) == (ours[0], ours[1]), words
        assert ours[0] == 2 or theirs[2] == ours[2], words
    with reading(served.folder / "registry.db") as connection:
        assert verify(connection, served.folder / "registry.key").findings == ()
        actions = {link.entry.action for link in log_page(connection, 0, 1_000)}
    assert actions == {"publish", "deployment", "state", "support ended", "rule", "approve", "reject", "acknowledge"}


def test_what_a_service_refuses_leads_to_the_option(served: Served, run: Run, tmp_path: Path) -> None:
    client = client_of(served, tmp_path / "client")
    (client / "extra.vspec").write_text("Vehicle.Extra: {type: branch, description: More.}\n", encoding="utf-8")
    assert "pass `--version V`" in run(client, "publish extra.vspec")[2]
    assert "Unknown catalogue 'flet'. Did you mean 'fleet'?" in run(client, "check CoreAcc.yaml -s flet")[2]


def test_a_token_is_taken_from_the_environment(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "served"
    folder.mkdir()
    write(folder, DATABASE.replace('key = "registry.key"\n', ""))
    with writing(folder / "registry.db") as connection:
        secret = create_token(connection, "ci", ["publish"], "Team CoreAcc", "")
    with serving(folder) as service:
        client = client_of(service, tmp_path / "client")
        status, _, told = run(client, "publish CoreAcc.yaml")
        assert (status, "must have a token" in told, secret in told) == (2, True, False)
        assert "a token is needed: set SIGCAT_TOKEN." in told
        monkeypatch.setenv("SIGCAT_TOKEN", f"{secret}x")
        status, _, told = run(client, "publish CoreAcc.yaml")
        assert (status, "The token of the request is not one of this registry." in told) == (2, True)
        assert "SIGCAT_TOKEN" not in told
        monkeypatch.setenv("SIGCAT_TOKEN", secret)
        assert run(client, "publish CoreAcc.yaml")[0] == 0
        assert "E015" in run(client, "publish User.yaml")[2]
        assert run(client, "registry record-deployment SUV-2025 CoreAcc@1.0.0")[0] == 2
        monkeypatch.setenv("SIGCAT_TOKEN", f" {secret}\n")
        assert run(client, "publish CoreAcc.yaml")[0] == 0
        monkeypatch.setenv("SIGCAT_TOKEN", f"{secret}\nX: y")
        status, _, told = run(client, "publish CoreAcc.yaml")
        assert (status, "SIGCAT_TOKEN" in told, secret in told) == (2, True, False)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("users Vehicle.S0 --server http://127.0.0.1:9", "does not answer"),
        ("users Vehicle.S0 --server ftp://signals.example", "must be an address"),
        ("users Vehicle.S0 --server http://user:word@signals.example", "must be an address"),
        ("registry verify", "runs where the database"),
        ("registry export", "runs where the database"),
        ("registry token list", "runs where the database"),
        ("publish CoreAcc.yaml -l signals.vspec", "catalogue that it hosts"),
        ("publish missing.yaml", "no such file"),
        ("publish sigcat.toml --version 1.0.0", "must be a function, an overlay or the root"),
    ],
)
def test_what_a_service_cannot_do_is_said(served: Served, run: Run, tmp_path: Path, words: str, told: str) -> None:
    status, _, text = run(client_of(served, tmp_path / "client"), words)
    assert (status, told in text, "Traceback" in text) == (2, True, False), text


@pytest.mark.parametrize(
    "settings",
    [
        'server = "signals.example"',
        'server = "http://a"\ndatabase = "a.db"',
        'server = "http://a"\nkey = "a"',
        "server = 1",
    ],
)
def test_a_server_that_is_wrong_in_the_project_is_reported(run: Run, tmp_path: Path, settings: str) -> None:
    write(tmp_path, f"[registry]\n{settings}\n")
    status, _, text = run(tmp_path, "registry list")
    assert (status, "sigcat.toml:" in text, "Traceback" in text) == (2, True, False), text


def test_events_of_a_service_are_those_of_its_database(served: Served, run: Run, tmp_path: Path) -> None:
    client = client_of(served, tmp_path / "client")
    run(client, "publish CoreAcc.yaml User.yaml Provider.yaml")
    status, lines, _ = run(served.folder, "registry events")
    assert (status, lines.count("\n") >= 3) == (0, True)
    assert run(client, "registry events") == (0, lines, "")
    first, rest = lines.split("\n", 1)
    assert run(client, f"registry events --after {json.loads(first)['id']}") == (0, rest, "")
    status, printed, text = run(client, "registry events --after 00")
    assert (status, printed, "error E005" in text) == (1, "", True)
    _, printed, _ = run(client, "registry events --format text")
    assert printed.splitlines()[0].split("  ")[1:] == ["published", "CoreAcc@1.0.0"]


def test_events_are_followed_over_a_restart_of_the_service_until_an_interrupt(tmp_path: Path, run: Run) -> None:
    folder = tmp_path / "served"
    folder.mkdir()
    write(folder, DATABASE.replace('key = "registry.key"\n', ""))
    with ExitStack() as stack:
        with serving(folder) as service:
            client = client_of(service, tmp_path / "client")
            assert run(client, "publish CoreAcc.yaml")[0] == 0
            command = [sys.executable, "-m", "sigcat.cli", "registry", "events", "--follow"]
            following = stack.enter_context(
                subprocess.Popen(command, cwd=client, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            )
            stack.callback(following.kill)
            assert following.stdout is not None
            assert following.stderr is not None
            assert json.loads(following.stdout.readline())["subject"] == "CoreAcc@1.0.0"
            assert run(client, "publish User.yaml")[0] == 0
            assert json.loads(following.stdout.readline())["subject"] == "User@1.0.0"
        assert "does not answer" in following.stderr.readline()
        assert run(folder, "publish Provider.yaml")[0] == 0
        port = service.address.rpartition(":")[2].strip("/")
        with serving(folder, port):
            assert json.loads(following.stdout.readline())["subject"] == "Provider@1.0.0"
            following.send_signal(signal.SIGINT)
            assert following.wait(30) == 0
        assert following.stderr.read() == ""


@contextmanager
def following(client: Path) -> Iterator["subprocess.Popen[str]"]:
    """A command that follows the events of a service."""
    command = [sys.executable, "-m", "sigcat.cli", "registry", "events", "--follow"]
    with subprocess.Popen(command, cwd=client, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


def line_of(stream: IO[str] | None) -> str:
    assert stream is not None
    return stream.readline()


def test_another_log_at_the_same_address_ends_following(tmp_path: Path, run: Run) -> None:
    """The numbers of its entries mean other events."""
    before, after = tmp_path / "before", tmp_path / "after"
    for folder, file in ((before, "CoreAcc.yaml"), (after, "User.yaml")):
        folder.mkdir()
        write(folder, DATABASE.replace('key = "registry.key"\n', ""))
        assert run(folder, f"publish {file}")[0] == 0
    with ExitStack() as stack:
        with serving(before) as service:
            follower = stack.enter_context(following(client_of(service, tmp_path / "client")))
            assert json.loads(line_of(follower.stdout))["subject"] == "CoreAcc@1.0.0"
        assert "does not answer" in line_of(follower.stderr)
        with serving(after, service.address.rpartition(":")[2].strip("/")):
            assert follower.wait(60) == 2
        assert "has another log than before" in line_of(follower.stderr)


def test_a_service_with_a_follower_stops_without_force(tmp_path: Path, run: Run) -> None:
    """Who waits for events is answered."""
    write(tmp_path, DATABASE.replace('key = "registry.key"\n', ""))
    assert run(tmp_path, "publish CoreAcc.yaml")[0] == 0
    command = [sys.executable, "-m", "sigcat.cli", "serve", "--port", "0"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        service = Served(line_of(process.stdout).split()[3], process, tmp_path)
        with following(client_of(service, tmp_path / "client")) as follower:
            line_of(follower.stdout)
            process.terminate()
            assert process.stderr is not None
            assert "graceful shutdown exceeded" not in process.stderr.read()


def test_an_answer_that_is_cut_is_one_that_may_come_later(run: Run, tmp_path: Path) -> None:
    write(tmp_path, PROJECT)
    with answering(200, {"Content-Length": "900"}, b'{"epoch": 1,') as (address, _):
        status, _, text = run(tmp_path, f"registry events --server {address}")
    assert (status, "its answer was cut off" in text) == (2, True), text


def test_a_service_that_does_not_answer_at_first_is_not_waited_for(run: Run, tmp_path: Path) -> None:
    write(tmp_path, PROJECT)
    status, _, text = run(tmp_path, "registry events --follow --server http://127.0.0.1:9")
    assert (status, "does not answer" in text) == (2, True)


# -- servers that are no service, or end ----------------------------------------------------------------------------


@contextmanager
def answering(status: int, headers: dict[str, str], body: bytes) -> Iterator[tuple[str, list[str]]]:
    """A server that gives everything the same answer; and the addresses and tokens that it was sent."""
    asked: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            asked.append(f"{self.path} {self.headers.get('Authorization')}")
            self.send_response(status)
            for name, value in {"Content-Length": str(len(body)), **headers}.items():
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_: object) -> None:
            pass

    with HTTPServer(("127.0.0.1", 0), Handler) as server:
        threading.Thread(target=server.serve_forever, args=(0.01,), daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}", asked
        server.shutdown()


@pytest.mark.parametrize(
    ("status", "body"),
    [
        (200, b"<html>"),
        (200, b""),
        (404, b"<html>"),
        (500, b"{}"),
        (502, b'{"detail": 1}'),
        (599, b""),
        (200, b"[]"),
        (200, b'{"head": {}}'),
    ],
)
def test_an_answer_that_is_not_one_of_sigcat_is_reported(run: Run, tmp_path: Path, status: int, body: bytes) -> None:
    write(tmp_path, PROJECT)
    with answering(status, {}, body) as (address, _):
        ended, _, told = run(tmp_path, f"registry list --server {address}")
    assert (ended, address in told, "internal error" in told) == (2, True, False), told


def test_a_service_without_its_database_names_itself_and_the_cause(run: Run, tmp_path: Path) -> None:
    write(tmp_path, PROJECT)
    finding = {"rule": "E011", "severity": "error", "message": "The database cannot be used: connection refused."}
    body = json.dumps({"detail": "The registry cannot be used now.", "findings": [finding]}).encode()
    with answering(503, {}, body) as (address, _):
        status, _, told = run(tmp_path, f"registry list --server {address}")
    cause = "The database cannot be used: connection refused. Run the command again."
    assert (status, told) == (2, f"sigcat: {address}: The registry cannot be used now. {cause}\n")


def test_a_token_is_not_sent_to_where_a_server_redirects(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SIGCAT_TOKEN", "secret")
    write(tmp_path, PROJECT)
    with answering(200, {}, b"{}") as (other, asked), answering(302, {"Location": other}, b"") as (address, first):
        assert run(tmp_path, f"registry list --server {address}")[0] == 2
    assert (len(first), asked) == (1, [])


def test_a_service_that_is_killed_while_it_publishes_leaves_a_registry_that_verifies(tmp_path: Path, run: Run) -> None:
    folder = tmp_path / "served"
    folder.mkdir()
    write(folder, DATABASE.replace('key = "registry.key"\n', ""))
    for number in range(3):
        with serving(folder) as service:
            client = client_of(service, tmp_path / f"client{number}")
            for each in range(40):
                (client / f"F{each}.yaml").write_bytes(
                    function_file(f"F{number}x{each}", "{path: Vehicle.S0, role: consumed}")
                )
            command = [sys.executable, "-m", "sigcat.cli", "publish", *(f"F{each}.yaml" for each in range(40))]
            with subprocess.Popen(
                command, cwd=client, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, env={**os.environ}
            ) as publishing:
                time.sleep(0.7 + 0.5 * number)
                service.process.send_signal(signal.SIGKILL)
                _, told = publishing.communicate()
                assert "Traceback" not in told
    with reading(folder / "registry.db") as connection:
        checked = verify(connection)
        assert (checked.findings, checked.entries % 40) == ((), 0)


def test_two_services_on_one_database_write_one_log(tmp_path: Path, run: Run) -> None:
    folder = tmp_path / "served"
    folder.mkdir()
    write(folder, DATABASE.replace('key = "registry.key"\n', ""))
    with serving(folder) as one, serving(folder) as other:
        writers = []
        for number, service in enumerate((one, other)):
            client = client_of(service, tmp_path / f"client{number}")
            (client / "F.yaml").write_bytes(function_file(f"F{number}", "{path: Vehicle.S0, role: consumed}"))
            program = f"{shlex.quote(sys.executable)} -m sigcat.cli"
            command = f"{program} publish F.yaml && {program} registry record-deployment L F{number}@1.0.0"
            writers.append(subprocess.Popen(["sh", "-c", command], cwd=client, stdout=subprocess.DEVNULL))
        assert [each.wait() for each in writers] == [0, 0]
    with reading(folder / "registry.db") as connection:
        last = head(connection)
        assert (verify(connection).findings, last.number if last else 0) == ((), 4)
