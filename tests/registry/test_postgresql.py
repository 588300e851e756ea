"""A registry on a PostgreSQL server: what a file does not have to survive."""

import multiprocessing
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.errors import RegistryUnusable
from sigcat.project.project import ServerUrl
from sigcat.registry.publish import publish
from sigcat.registry.published import all_versions
from sigcat.registry.storing.database import reading
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.tables import SCHEMA
from sigcat.registry.storing.verify import verify
from tests.needs import postgresql
from tests.registry.parts import plain_candidate
from tests.registry.server import Server, programs, running

pytestmark = postgresql
psycopg = pytest.importorskip("psycopg")
_FORK = multiprocessing.get_context("fork")
Run = Callable[..., tuple[int, str]]


@pytest.fixture
def own_server() -> Iterator[Server]:
    """A server that a test may stop."""
    folder = programs()
    assert folder is not None
    with running(folder) as started:
        yield started


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Run a command in a project with a database; its status and everything that it prints."""
    monkeypatch.chdir(tmp_path)

    def command(url: ServerUrl, *arguments: object) -> tuple[int, str]:
        Path("sigcat.toml").write_text(f'[registry]\ndatabase = "{url.text}"\n', encoding="utf-8")
        status = main([str(each) for each in arguments])
        printed = capsys.readouterr()
        return status, printed.out + printed.err

    return command


def versions_in(url: ServerUrl) -> list[str]:
    with reading(url) as connection:
        assert verify(connection).findings == ()
        return [each.version for each in all_versions(connection)]


def test_commands_have_the_same_answers_as_in_a_file(server: Server, run: Run, tmp_path: Path) -> None:
    url = server.new_database()
    core = EXAMPLES / "core_acc" / "function.yaml"
    assert "nothing is published in postgresql://sigcat@/" in run(url, "registry", "list")[1]
    assert run(url, "publish", core) == (0, "function CoreAcc 1.0.0: published\n")
    assert run(url, "registry", "record-deployment", "SUV-2025", "CoreAcc@1.0.0")[0] == 0
    assert run(url, "users", "Vehicle.Chassis.Brake.CylP")[1].startswith(
        "CoreAcc 1.0.0 consumes Vehicle.Chassis.Brake.CylP"
    )
    Path("speed.vspec").write_text("Vehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: m/s\n", encoding="utf-8")
    status, text = run(url, "check", "speed.vspec")
    assert (status, "breaks CoreAcc 1.0.0, call CoreAcc_Step" in text) == (1, True)
    assert run(url, "can-i-deploy", "CoreAcc@1.0.0", "--to", "SUV-2025")[0] == 0
    assert run(url, "registry", "show", "CoreAcc@1.0.0")[1].encode() == core.read_bytes()
    assert run(url, "registry", "export", "-o", "all.jsonl")[0] == 0
    assert run(url, "registry", "verify")[0] == 0
    assert not [each for each in tmp_path.iterdir() if "postgresql" in each.name]


def test_a_server_that_goes_away_is_reported_and_used_again_when_it_returns(own_server: Server, run: Run) -> None:
    url = own_server.new_database()
    publish(Registry(url), [plain_candidate("name", "1.0.0")])
    own_server.stop()
    for arguments in (("registry", "list"), ("registry", "rule", "name", "full", "--kind", "overlay")):
        status, text = run(url, *arguments)
        assert (status, "error E011 The database cannot be used" in text, "Traceback" in text) == (2, True, False)
    own_server.start()
    assert run(url, "registry", "list") == (0, "overlay name 1.0.0: published, owner A team\n")
    publish(Registry(url), [plain_candidate("name", "1.1.0")])
    assert versions_in(url) == ["1.0.0", "1.1.0"]


def test_a_server_that_ends_within_a_transaction_keeps_nothing_of_it(own_server: Server) -> None:
    url = own_server.new_database()
    process = _FORK.Process(target=_publish_for_ever, args=(url,))
    process.start()
    time.sleep(1)
    own_server.stop()
    process.join(60)
    assert process.exitcode == 11, "every error must be a finding"
    own_server.start()
    found = versions_in(url)
    assert found == [f"1.{number}.0" for number in range(len(found))]
    publish(Registry(url), [plain_candidate("name", f"1.{len(found)}.0")])


def _publish_for_ever(url: ServerUrl) -> None:
    try:
        for number in range(100_000):
            publish(Registry(url), [plain_candidate("name", f"1.{number}.0", b"x" * 10_000 + str(number).encode())])
    except RegistryUnusable:
        raise SystemExit(11) from None


def test_a_dump_that_is_made_while_others_write_is_a_whole_registry(server: Server) -> None:
    url, copy = server.new_database(), server.new_database()
    process = _FORK.Process(target=_publish_for_ever, args=(url,))
    process.start()
    time.sleep(0.5)
    dump = server.run("pg_dump", "--dbname", _name(url))
    process.kill()
    process.join()
    file = server.data.parent / f"{_name(copy)}.sql"
    file.write_bytes(dump)
    file.chmod(0o644)
    server.run("psql", "-q", "-v", "ON_ERROR_STOP=1", "-d", _name(copy), "-f", str(file))
    found = versions_in(copy)
    assert found == [f"1.{number}.0" for number in range(len(found))]
    publish(Registry(copy), [plain_candidate("name", f"1.{len(found)}.0")])
    assert len(versions_in(copy)) == len(found) + 1


def _name(url: ServerUrl) -> str:
    return url.text.partition("@/")[2].partition("?")[0]


@pytest.mark.parametrize(
    ("statement", "message"),
    [
        (
            f"UPDATE alembic_version SET version_num = '{SCHEMA + 1}'",
            f"The schema of the database must be at most {SCHEMA}",
        ),
        ("UPDATE alembic_version SET version_num = 'ae1027a6acf'", "The database belongs to another program"),
    ],
)
def test_a_database_of_a_newer_schema_or_another_program_is_refused(
    server: Server, run: Run, statement: str, message: str
) -> None:
    url = server.new_database()
    publish(Registry(url), [plain_candidate("name", "1.0.0")])
    with psycopg.connect(url.text) as connection:
        connection.execute(statement)
    for arguments in (("registry", "list"), ("registry", "rule", "name", "full")):
        status, text = run(url, *arguments)
        assert (status, message in text) == (2, True), text


@pytest.mark.parametrize(
    "change",
    [
        ("@/registry", "@/nothing"),
        ("?host=", "?host=/nowhere"),
        ("sigcat@", "nobody@"),
        ("sigcat@/", "sigcat@localhost:port/"),
    ],
)
def test_a_database_that_cannot_be_reached_is_a_finding(server: Server, run: Run, change: tuple[str, str]) -> None:
    url = server.new_database()
    status, text = run(ServerUrl(url.text.replace(*change)), "registry", "list")
    is_helpful = "postgresql://USER@HOST/NAME" in text
    assert (status, "error E011" in text, is_helpful, "Traceback" in text) == (2, True, True, False), text


def test_no_command_shows_a_password(server: Server, run: Run) -> None:
    url = ServerUrl(server.new_database().text.replace("sigcat@", "sigcat:hidden@") + "&password=hidden")
    for arguments in (("registry", "list"), ("config", "--show")):
        _, text = run(url, *arguments)
        assert ("sigcat:***@" in text, "hidden" in text) == (True, False), text


@pytest.mark.parametrize("url", ["mysql://host/name", "postgres://host/name", "http://host"])
def test_a_url_of_another_database_is_a_finding_with_its_line(run: Run, url: str) -> None:
    status, text = run(ServerUrl(url), "registry", "list")
    assert (status, text.startswith("sigcat.toml:2:"), "postgresql://USER@HOST/NAME" in text) == (2, True, True), text
