"""Writers at the same time, writers that are killed, and disks that are full."""

import multiprocessing
import os
import random
import resource
import signal
import sqlite3
import tempfile
import time
from contextlib import suppress
from pathlib import Path

import pytest
from sqlalchemy import Connection

from sigcat.errors import InputRefused, RegistryUnusable
from sigcat.registry.publish import publish
from sigcat.registry.published import all_versions
from sigcat.registry.storing import sqlite as store
from sigcat.registry.storing.database import Place, reading
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.verify import verify
from tests.needs import IS_SLOW_RUN
from tests.registry.parts import plain_candidate

WRITERS, VERSIONS = 20, 5
KILLS = 100 if IS_SLOW_RUN else 10
_FORK = multiprocessing.get_context("fork")


def versions_in(database: Place) -> list[str]:
    with reading(database) as connection:
        assert verify(connection).findings == ()
        return [each.version for each in all_versions(connection)]


def _write(arguments: tuple[Place, int]) -> int:
    """Publish versions of one name, and one that all writers publish with other bytes; return how many of these won."""
    database, writer = arguments
    for number in range(VERSIONS):
        publish(Registry(database), [plain_candidate("shared", f"1.{writer}.{number}")])
    try:
        publish(Registry(database), [plain_candidate("shared", "2.0.0", str(writer).encode())])
    except InputRefused as refused:
        return 0 if [each.rule for each in refused.findings] == ["E003"] else 100
    return 1


def test_twenty_writers_of_one_name_make_no_version_twice_and_lose_none(place: Place) -> None:
    with _FORK.Pool(WRITERS) as pool:
        winners = pool.map(_write, [(place, writer) for writer in range(WRITERS)])
    assert sum(winners) == 1
    expected = [f"1.{writer}.{number}" for writer in range(WRITERS) for number in range(VERSIONS)]
    assert versions_in(place) == [*expected, "2.0.0"]


def test_equal_bytes_of_parallel_writers_are_published_once_and_unchanged_for_the_others(place: Place) -> None:
    with _FORK.Pool(WRITERS) as pool:
        found = pool.starmap(_publish_same, [(place,)] * WRITERS)
    assert sorted(found) == ["published", *["unchanged"] * (WRITERS - 1)]
    assert versions_in(place) == ["1.0.0"]


def _publish_same(database: Place) -> str:
    return publish(Registry(database), [plain_candidate("same", "1.0.0")]).outcomes[0].status


@pytest.mark.parametrize("seed", range(KILLS))
def test_after_a_kill_every_answered_version_is_there_and_every_other_is_whole_or_absent(
    place: Place, tmp_path: Path, seed: int
) -> None:
    answers = tmp_path / "answers"
    process = _FORK.Process(target=_publish_until_killed, args=(place, answers))
    process.start()
    while not answers.exists():
        time.sleep(0.001)
    time.sleep(random.Random(seed).uniform(0, 0.2))
    process.kill()
    process.join()
    answered = answers.read_text(encoding="utf-8").split()
    found = versions_in(place)
    assert found[: len(answered)] == answered
    assert len(found) - len(answered) in (0, 1)
    assert publish(Registry(place), [plain_candidate("after", "1.0.0")]).outcomes[0].status == "published"


def _publish_until_killed(database: Place, answers: Path) -> None:
    for number in range(100_000):
        content = random.Random(number).randbytes(20_000)
        publish(Registry(database), [plain_candidate("killed", f"1.{number}.0", content)])
        with answers.open("a", encoding="utf-8") as file:
            file.write(f"1.{number}.0\n")


def test_a_backup_that_is_made_while_others_write_is_a_whole_registry(tmp_path: Path) -> None:
    database, backup, answers = tmp_path / "registry.db", tmp_path / "backup.db", tmp_path / "answers"
    process = _FORK.Process(target=_publish_until_killed, args=(database, answers))
    process.start()
    while not answers.exists():
        time.sleep(0.001)
    source, target = sqlite3.connect(database), sqlite3.connect(backup)
    source.backup(target, pages=1)
    source.close()
    target.close()
    process.kill()
    process.join()
    found = versions_in(backup)
    assert found == [f"1.{number}.0" for number in range(len(found))]
    assert publish(Registry(backup), [plain_candidate("after", "1.0.0")]).outcomes[0].status == "published"


def test_a_full_disk_is_a_finding_and_nothing_is_published_by_half(tmp_path: Path) -> None:
    database = tmp_path / "registry.db"
    publish(Registry(database), [plain_candidate("small", "1.0.0")])
    with _FORK.Pool(1) as pool:
        rules, fix = pool.apply(_publish_on_full_disk, (database,))
    assert rules == ["E011"]
    assert fix
    assert versions_in(database) == ["1.0.0"]
    big = [plain_candidate("big", "1.0.0", os.urandom(3_000_000)), plain_candidate("second", "1.0.0")]
    assert len(publish(Registry(database), big).outcomes) == 2


def _publish_on_full_disk(database: Path) -> tuple[list[str], str]:
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1_000_000, 1_000_000))
    big = [plain_candidate("second", "1.0.0"), plain_candidate("big", "1.0.0", os.urandom(3_000_000))]
    try:
        publish(Registry(database), big)
    except InputRefused as refused:
        return [each.rule for each in refused.findings], refused.findings[0].fix
    return [], ""


@pytest.mark.parametrize(("file_mode", "folder_mode"), [(0o444, 0o777), (0o444, 0o555), (0o644, 0o555)])
def test_who_may_only_read_leaves_no_files(file_mode: int, folder_mode: int) -> None:
    with tempfile.TemporaryDirectory() as name:
        database = Path(name, "registry.db")
        publish(Registry(database), [plain_candidate("small", "1.0.0")])
        store.close_all()
        database.chmod(file_mode)
        database.parent.chmod(folder_mode)
        process = _FORK.Process(target=_read_as_another_user, args=(database,))
        process.start()
        process.join()
        assert process.exitcode == 0
        assert [each.name for each in database.parent.iterdir()] == ["registry.db"]
        database.parent.chmod(0o700)


def _read_as_another_user(database: Path) -> None:
    if os.geteuid() == 0:
        os.setgid(65534)
        os.setuid(65534)
    assert versions_in(database) == ["1.0.0"]
    with pytest.raises(RegistryUnusable):
        publish(Registry(database), [plain_candidate("small", "1.1.0")])
    store.close_all()


def test_what_was_read_while_another_user_wrote_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    database = tmp_path / "registry.db"
    publish(Registry(database), [plain_candidate("small", "1.0.0")])
    store.close_all()
    monkeypatch.setattr("os.access", lambda *_: False)
    with pytest.raises(RegistryUnusable) as refused, reading(database):
        _write_meanwhile(database, monkeypatch)
    assert refused.value.findings[0].fix == "Run the command again."
    assert versions_in(database) == ["1.0.0", "1.1.0"]


def _write_meanwhile(database: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    publish(Registry(database), [plain_candidate("small", "1.1.0")])


@pytest.mark.parametrize("folder", ["/proc", "/nowhere/at/all"])
def test_a_place_that_cannot_be_written_is_a_finding(folder: str) -> None:
    database = Path(folder, "registry.db")
    with pytest.raises(InputRefused) as refused:
        publish(Registry(database), [plain_candidate("small", "1.0.0")])
    assert [(each.rule, each.file) for each in refused.value.findings] == [("E011", str(database))]


def test_tables_that_another_process_creates_meanwhile_are_those_of_the_registry(tmp_path: Path, monkeypatch) -> None:
    file, read = tmp_path / "registry.db", store._header

    def meanwhile(connection: Connection) -> tuple[int, int]:
        schema, application = read(connection)
        if application == 0:
            other = sqlite3.connect(file, timeout=0, isolation_level=None)
            with suppress(sqlite3.OperationalError):  # it has to wait
                other.executescript("BEGIN EXCLUSIVE; CREATE TABLE names (id INTEGER); COMMIT")
            other.close()
        return schema, application

    monkeypatch.setattr(store, "_header", meanwhile)
    assert _publish_same(file) == "published"
