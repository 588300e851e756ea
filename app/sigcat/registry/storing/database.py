"""The database of a registry: transactions that are durable and exclude other writers, and snapshots to read.

A new database gets its tables in its first transaction. An older schema is upgraded when it is opened.
"""

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TypeAlias, cast

from sqlalchemy import Connection
from sqlalchemy.exc import DBAPIError

from sigcat import codes
from sigcat.errors import InputRefused, RegistryUnusable
from sigcat.limits import REGISTRY_SECONDS
from sigcat.project.project import ServerUrl
from sigcat.registry.reference import NO_ANSWER, UNCHANGED, unusable
from sigcat.registry.storing.sqlite import SqliteStore, in_memory_engine
from sigcat.registry.storing.store import Store
from sigcat.registry.storing.tables import METADATA, REVISION, SCHEMA

Place: TypeAlias = Path | ServerUrl
"""File of an SQLite database, or URL of a PostgreSQL database."""
Snapshot: TypeAlias = Connection
"""One state of the registry, to read."""


@contextmanager
def writing(place: Place, seconds: float = REGISTRY_SECONDS) -> Iterator[Connection]:
    """A transaction that writes, after those of others. Nothing of it is kept if the block raises."""
    store = _store(place)
    with _reported(store), store.connected() as connection, store.exclusive(connection, seconds):
        _make_current(store, connection)
        yield connection


@contextmanager
def reading(place: Place) -> Iterator[Connection]:
    """A transaction that sees one state. A missing database is empty, and is not created.

    Refusals do not say that nothing was changed: reading changes nothing.
    """
    try:
        with _snapshot(place) as connection:
            yield connection
    except RegistryUnusable as error:
        raise RegistryUnusable(NO_ANSWER, error.findings, is_full=error.is_full) from None
    except InputRefused as error:
        if str(error) != UNCHANGED:
            raise
        raise InputRefused(NO_ANSWER, error.findings) from None


@contextmanager
def _snapshot(place: Place) -> Iterator[Connection]:
    store = _store(place)
    with _reported(store):
        if not store.exists():
            with in_memory() as empty:
                yield empty
            return
        with store.connected() as connection:
            if _checked(store, connection) not in (0, SCHEMA):
                with store.exclusive(connection, REGISTRY_SECONDS):
                    _make_current(store, connection)
            with store.snapshot(connection):
                if _known_schema(store, connection):
                    yield connection
                    return
            with in_memory() as empty:
                yield empty


@contextmanager
def in_memory() -> Iterator[Connection]:
    """An empty registry that is not kept."""
    with in_memory_engine().connect() as connection:
        _driver(connection).executescript(_statements())
        yield connection


@lru_cache(maxsize=1)
def _statements() -> str:
    """The statements that make an empty registry in SQLite. SQLAlchemy needs ten times as long to write and check them."""
    with in_memory_engine().begin() as connection:
        _create(connection)
        return "\n".join(_driver(connection).iterdump())


def _driver(connection: Connection) -> sqlite3.Connection:
    return cast(sqlite3.Connection, connection.connection.driver_connection)


def _store(place: Place) -> Store:
    if isinstance(place, Path):
        return SqliteStore(place)
    from sigcat.registry.storing.postgresql import PostgresqlStore

    return PostgresqlStore(place)


def _make_current(store: Store, connection: Connection) -> None:
    """Create the tables, or upgrade them. Of programs that start at once, one does: this is a transaction that writes."""
    schema = _known_schema(store, connection)
    if schema == SCHEMA:
        return
    if schema == 0:
        _create(connection)
    else:
        from sigcat.registry.storing.upgrading import upgrade

        upgrade(connection, schema)
    store.set_schema(connection)


def _create(connection: Connection) -> None:
    METADATA.create_all(connection)
    connection.execute(REVISION.insert(), {"version_num": str(SCHEMA)})


def _checked(store: Store, connection: Connection) -> int:
    with store.snapshot(connection):
        return _known_schema(store, connection)


def _known_schema(store: Store, connection: Connection) -> int:
    """Return the schema, 0 of a new database. Refuses a database of a newer program."""
    schema = store.schema(connection)
    if schema > SCHEMA:
        message = f"The schema of the database must be at most {SCHEMA}, not {schema}."
        raise unusable(codes.REGISTRY_UNUSABLE.finding(message, store.name, fix="Use a newer sigcat."))
    return schema


@contextmanager
def _reported(store: Store) -> Iterator[None]:
    """Report errors of the driver as findings about the database."""
    try:
        yield
    except DBAPIError as error:
        text = str(error.orig).partition("\n")[0].rpartition("failed: ")[2].strip().rstrip(".")  # without its address
        message = f"The database cannot be used: {text}."
        finding = codes.REGISTRY_UNUSABLE.finding(message, store.name, fix=store.advice(error))
        raise unusable(finding, is_full=store.is_full(error)) from None
