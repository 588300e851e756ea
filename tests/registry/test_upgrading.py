"""A database of an older schema is upgraded when it is opened, and has the same answers and the same log."""

import sqlite3
import subprocess
import sys
from multiprocessing import get_context
from pathlib import Path

import pytest
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import Connection, create_engine, insert, select

from sigcat.errors import InputRefused
from sigcat.registry.lines import record
from sigcat.registry.publish import publish
from sigcat.registry.reference import Reference
from sigcat.registry.storing.database import Place, in_memory, reading
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.storing.tables import APPLICATION, CONTENTS, LOG, METADATA, SCHEMA
from sigcat.registry.storing.transfer import exported
from sigcat.registry.storing.upgrading import config_of
from sigcat.registry.storing.verify import verify
from sigcat.registry.users import users_of
from tests.needs import postgresql
from tests.registry.parts import candidate, catalogue, declaration
from tests.registry.server import Server

CATALOGUE = catalogue()


@pytest.fixture
def newest(tmp_path: Path) -> Registry:
    """A registry of the newest schema."""
    made = Registry(tmp_path / "registry.db")
    publish(made, [candidate(declaration("Alpha", ("S0",), ("S1",)), CATALOGUE)])
    publish(made, [candidate(declaration("Beta", ("S1",)), CATALOGUE)])
    record(made, "release", "SUV-2025", Reference("Alpha", "1.0.0"))
    return made


@pytest.fixture
def older(newest: Registry, tmp_path: Path) -> Registry:
    """The same log and content in a file of schema 1."""
    return copied(newest, tmp_path / "older.db")


def copied(newest: Registry, place: Place) -> Registry:
    """The log and content of a registry in a database of schema 1. That of a file has its number in the header alone."""
    made = Registry(place)
    engine = create_engine(f"sqlite:///{place}" if isinstance(place, Path) else place.text.replace(":", "+psycopg:", 1))
    with reading(newest.database) as source, engine.begin() as connection:
        command.upgrade(config_of(connection), "1")
        for table in (CONTENTS, LOG):
            connection.execute(insert(table), [row._asdict() for row in source.execute(select(table))])
        header = ("PRAGMA user_version = 1", f"PRAGMA application_id = {APPLICATION}")
        for statement in ("DROP TABLE alembic_version", *header) if isinstance(place, Path) else ():
            connection.exec_driver_sql(statement)
    engine.dispose()
    return made


def answers(registry: Registry) -> tuple[object, ...]:
    with reading(registry.database) as connection:
        assert verify(connection).findings == ()
        return users_of(connection, "Vehicle.S1"), list(exported(connection))


def schema_of(registry: Registry) -> int:
    assert isinstance(registry.database, Path)
    connection = sqlite3.connect(registry.database)
    ((number,),) = connection.execute("PRAGMA user_version")
    connection.close()
    return int(number)


def test_reading_upgrades_a_file_and_keeps_its_log_and_content(newest: Registry, older: Registry) -> None:
    assert schema_of(older) == 1
    assert answers(older) == answers(newest)
    assert schema_of(older) == SCHEMA


@postgresql
def test_reading_upgrades_a_database_of_a_server(newest: Registry, server: Server) -> None:
    older = copied(newest, server.new_database())
    with get_context("fork").Pool(4) as pool:
        assert pool.map(answers, [older] * 4) == [answers(newest)] * 4
    assert publish(older, [candidate(declaration("Gamma", ("S2",)), CATALOGUE)]).outcomes[0].status == "published"


def test_writing_upgrades_a_database(older: Registry) -> None:
    assert publish(older, [candidate(declaration("Gamma", ("S2",)), CATALOGUE)]).outcomes[0].status == "published"
    assert schema_of(older) == SCHEMA
    answers(older)


def test_of_processes_that_open_an_older_database_one_upgrades_it(newest: Registry, older: Registry) -> None:
    with get_context("fork").Pool(4) as pool:
        assert pool.map(answers, [older] * 8) == [answers(newest)] * 8


def test_a_database_with_a_changed_log_keeps_its_schema(older: Registry) -> None:
    assert isinstance(older.database, Path)
    connection = sqlite3.connect(older.database, isolation_level=None)
    connection.execute("UPDATE log SET text = '[]' WHERE number = 2")
    connection.close()
    with pytest.raises(InputRefused) as refused, reading(older.database):
        pass
    (finding,) = refused.value.findings
    assert (finding.rule, finding.path) == ("E010", "log/2")
    assert schema_of(older) == 1


def test_the_revisions_make_the_tables_of_a_new_database() -> None:
    engine = create_engine("sqlite://")
    with engine.begin() as connection:
        command.upgrade(config_of(connection), "head")
        assert compare_metadata(MigrationContext.configure(connection), METADATA) == []
        with in_memory() as made:
            assert tables_of(connection) == tables_of(made)


def tables_of(connection: Connection) -> set[str]:
    found = connection.exec_driver_sql("SELECT name FROM sqlite_master WHERE name NOT LIKE 'sqlite_%'")
    return set(found.scalars())


def test_only_an_upgrade_loads_alembic(older: Registry, newest: Registry) -> None:
    code = (
        "import sys; from pathlib import Path; from sigcat.registry.storing.database import writing\n"
        "for name in sys.argv[1:]:\n"
        "    with writing(Path(name)): print('alembic' in sys.modules)\n"
    )
    ended = subprocess.run(
        [sys.executable, "-c", code, f"{older.database}.new", str(newest.database), str(older.database)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert ended.stdout.split() == ["False", "False", "True"]
