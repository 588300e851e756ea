"""The SQLite database of a registry: opening, and transactions that are durable and exclude other writers.

The schema has one revision. It is created in one transaction, and its number is in the header of the file. Alembic would
add two packages and its start-up time for the same result.
"""

import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import lru_cache
from pathlib import Path
from typing import TypeAlias

from sqlalchemy import Connection, Engine, NullPool, create_engine
from sqlalchemy.exc import DBAPIError

from sigcat import codes
from sigcat.errors import RegistryUnusable
from sigcat.limits import REGISTRY_SECONDS
from sigcat.registry.storing.tables import APPLICATION, METADATA, SCHEMA

Snapshot: TypeAlias = Connection
"""One state of the registry, to read."""
_ADVICE = {
    sqlite3.SQLITE_FULL: "Free space on the disk.",
    sqlite3.SQLITE_READONLY: "Make the file and its folder writable, and the files beside it that end in -wal and -shm.",
    sqlite3.SQLITE_CANTOPEN: "Make the file and its folder writable.",
    sqlite3.SQLITE_BUSY: "Run the command again.",
    sqlite3.SQLITE_NOTADB: "Name a file of sigcat, or a new one, as `database` in [registry].",
    sqlite3.SQLITE_CORRUPT: "Restore the file from a backup or an export.",
}
_PRIMARY = 0xFF
"""The bits of an extended error code that say what it is about."""


@contextmanager
def writing(database: Path) -> Iterator[Connection]:
    """A transaction that writes, after those of others. Nothing of it is kept if the block raises."""
    with _reported(database), _connected(database) as connection:
        _create(connection)
        with _transaction(connection, "BEGIN IMMEDIATE"):
            yield connection


@contextmanager
def reading(database: Path) -> Iterator[Connection]:
    """A transaction that sees one state. A missing database is empty, and is not created."""
    with _reported(database), _connected(database) if database.exists() else in_memory() as connection:
        with _transaction(connection, "BEGIN"):
            if _schema(connection) == SCHEMA:
                yield connection
                return
        with in_memory() as empty:
            yield empty


@contextmanager
def in_memory() -> Iterator[Connection]:
    """An empty registry that is not kept."""
    with _engine(":memory:").connect() as connection:
        METADATA.create_all(connection)
        connection.exec_driver_sql(f"PRAGMA user_version = {SCHEMA}")
        connection.exec_driver_sql(f"PRAGMA application_id = {APPLICATION}")
        yield connection


@contextmanager
def _connected(database: Path) -> Iterator[Connection]:
    with _engine(str(database)).connect() as connection:
        connection.exec_driver_sql("PRAGMA foreign_keys = ON")
        connection.exec_driver_sql("PRAGMA synchronous = FULL")
        yield connection


@lru_cache(maxsize=8)
def _engine(file: str) -> Engine:
    """The engine of a file, which keeps compiled statements and no connection."""

    def connect() -> sqlite3.Connection:
        return sqlite3.connect(file, timeout=REGISTRY_SECONDS, isolation_level=None)

    return create_engine("sqlite://", creator=connect, poolclass=NullPool)


@contextmanager
def _transaction(connection: Connection, begin: str) -> Iterator[None]:
    """Begin and end a transaction of SQLite: the driver would begin it at the first write only."""
    connection.exec_driver_sql(begin)
    try:
        yield
        connection.exec_driver_sql("COMMIT")
    except BaseException:
        with suppress(DBAPIError):  # a full disk has ended it already
            connection.exec_driver_sql("ROLLBACK")
        raise


def _create(connection: Connection) -> None:
    """Create the tables, unless they exist. Of programs that start at once, one creates them."""
    with _transaction(connection, "BEGIN"):
        schema = _schema(connection)
    if schema == SCHEMA:
        return
    _use_wal(connection)
    with _transaction(connection, "BEGIN EXCLUSIVE"):
        if _number(connection, "user_version") == 0:
            METADATA.create_all(connection)
            connection.exec_driver_sql(f"PRAGMA user_version = {SCHEMA}")
            connection.exec_driver_sql(f"PRAGMA application_id = {APPLICATION}")


def _use_wal(connection: Connection) -> None:
    """Switch the journal. SQLite refuses this at once while others are connected, so it is tried again."""
    end = time.monotonic() + REGISTRY_SECONDS
    while True:
        try:
            connection.exec_driver_sql("PRAGMA journal_mode = WAL")
        except DBAPIError as error:
            if _code(error) != sqlite3.SQLITE_BUSY or time.monotonic() > end:
                raise
            time.sleep(0.01)
        else:
            return


def _schema(connection: Connection) -> int:
    """Return the schema, 0 of a new file. Refuses a database of a newer program, or of another one.

    It reads the header three times, so it needs a transaction: another process may create the tables in between.
    """
    schema, application = _number(connection, "user_version"), _number(connection, "application_id")
    tables = connection.exec_driver_sql("SELECT count(*) FROM sqlite_master").scalar_one()
    if application != APPLICATION and (application or tables):
        message = "The database belongs to another program."
        raise RegistryUnusable(codes.REGISTRY_UNUSABLE.finding(message, fix=_ADVICE[sqlite3.SQLITE_NOTADB]))
    if schema > SCHEMA:
        message = f"The schema of the database must be {SCHEMA}, not {schema}."
        raise RegistryUnusable(codes.REGISTRY_UNUSABLE.finding(message, fix="Use a newer sigcat."))
    return schema


def _number(connection: Connection, name: str) -> int:
    return int(connection.exec_driver_sql(f"PRAGMA {name}").scalar_one())


@contextmanager
def _reported(database: Path) -> Iterator[None]:
    """Report errors of SQLite as findings about the file."""
    try:
        yield
    except DBAPIError as error:
        message = f"The database cannot be used: {error.orig}."
        fix = _ADVICE.get(_code(error), "Check the disk and the folder of the file.")
        finding = codes.REGISTRY_UNUSABLE.finding(message, str(database), fix=fix)
        raise RegistryUnusable(finding, is_full=_code(error) == sqlite3.SQLITE_FULL) from None
    except RegistryUnusable as error:
        (finding,) = error.findings
        raise RegistryUnusable(finding._replace(file=str(database)), is_full=error.is_full) from None


def _code(error: DBAPIError) -> int:
    return int(getattr(error.orig, "sqlite_errorcode", 0)) & _PRIMARY
