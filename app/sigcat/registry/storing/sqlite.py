"""A registry in a file: SQLite with a write-ahead log."""

import atexit
import os
import sqlite3
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import lru_cache
from pathlib import Path
from shutil import disk_usage
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from sqlalchemy import Connection, Engine, NullPool, QueuePool, create_engine, event
from sqlalchemy.exc import DBAPIError, DisconnectionError

from sigcat import codes
from sigcat.limits import REGISTRY_SECONDS
from sigcat.registry.reference import unusable
from sigcat.registry.storing.tables import APPLICATION, SCHEMA

_ADVICE: Mapping[int, str] = {
    sqlite3.SQLITE_FULL: "Free space on the disk.",
    sqlite3.SQLITE_READONLY: "Make the file and its folder writable, and the files beside it that end in -wal and -shm.",
    sqlite3.SQLITE_CANTOPEN: "Make the file and its folder writable.",
    sqlite3.SQLITE_BUSY: "Run the command again.",
    sqlite3.SQLITE_NOTADB: "Name a file of sigcat, or a new one, as `database` in [registry].",
    sqlite3.SQLITE_CORRUPT: "Restore the file from a backup or an export.",
}
_HEADER = "SELECT user_version, application_id FROM pragma_user_version, pragma_application_id"
_WAITS, _IN_WAL = "busy timeout", "journal mode is WAL"
"""Facts about a connection that need no question while it is open."""
_INDEX_BYTES = 32 * 1024
"""Bytes of the smallest index of a log (`-shm`)."""
_PRIMARY = 0xFF
"""The bits of an extended error code that say what it is about."""


class SqliteStore(NamedTuple):
    """The database of a file."""

    file: Path

    @property
    def name(self) -> str:
        """The file."""
        return str(self.file)

    def exists(self) -> bool:
        """Whether the file exists."""
        return self.file.exists()

    @contextmanager
    def connected(self) -> Iterator[Connection]:
        """A connection, which the process keeps: the last one of a file that is closed writes its log into the file."""
        if self._is_at_rest or self._has_no_room:
            with self._unchanged(), _read_only_engine(self.file).connect() as connection:
                yield connection
        else:
            with _engine(str(self.file)).connect() as connection:
                yield connection

    @property
    def _is_at_rest(self) -> bool:
        """Whether no process writes, and this one may not: SQLite would leave files beside it that no process removes."""
        is_writable = os.access(self.file, os.W_OK) and os.access(self.file.parent, os.W_OK)
        return not is_writable and self.exists() and not self._log.exists()

    @property
    def _has_no_room(self) -> bool:
        """Whether the disk has no room for the index of the log, which processes share, and the log is empty.

        Reading continues without it. An index that is there needs no more room.
        """
        if _size(self._log) or not self.exists() or _size(self.file.with_name(f"{self.file.name}-shm")) >= _INDEX_BYTES:
            return False
        return disk_usage(self.file.parent).free < 2 * _INDEX_BYTES

    @property
    def _log(self) -> Path:
        return self.file.with_name(f"{self.file.name}-wal")

    @contextmanager
    def _unchanged(self) -> Iterator[None]:
        """Refuse what was read in the block if another user began to write meanwhile."""
        before = self.file.stat()
        yield
        after = self.file.stat()
        if _size(self._log) or (before.st_ino, before.st_mtime_ns) != (after.st_ino, after.st_mtime_ns):
            message = "Others wrote to the database while it was read, and it is read-only here."
            fix = _ADVICE[sqlite3.SQLITE_BUSY]
            raise unusable(codes.REGISTRY_UNUSABLE.finding(message, self.name, fix=fix))

    @contextmanager
    def exclusive(self, connection: Connection, seconds: float) -> Iterator[None]:
        """A transaction that writes."""
        if connection.info.get(_WAITS) != seconds:
            connection.exec_driver_sql(f"PRAGMA busy_timeout = {seconds * 1000:.0f}")
            connection.info[_WAITS] = seconds
        if not connection.info.get(_IN_WAL):
            self._begin_wal(connection, seconds)
            connection.info[_IN_WAL] = True
        with _transaction(connection, "BEGIN IMMEDIATE"):
            yield

    def _begin_wal(self, connection: Connection, seconds: float) -> None:
        """Have the file use a log. It does so as long as this connection is open."""
        if connection.exec_driver_sql("PRAGMA journal_mode").scalar_one() != "wal":
            with self.snapshot(connection):
                self.schema(connection)  # the file of another program stays as it is
            _use_wal(connection, seconds)

    @contextmanager
    def snapshot(self, connection: Connection) -> Iterator[None]:
        """A transaction that reads."""
        with _transaction(connection, "BEGIN"):
            yield

    def schema(self, connection: Connection) -> int:
        """The number in the header.

        It reads the header up to three times, so it needs a transaction: another process may create the tables in between.
        """
        schema, application = _header(connection)
        if application != APPLICATION and (application or _has_tables(connection)):
            message = "The database belongs to another program."
            fix = _ADVICE[sqlite3.SQLITE_NOTADB]
            raise unusable(codes.REGISTRY_UNUSABLE.finding(message, self.name, fix=fix))
        return schema

    def set_schema(self, connection: Connection) -> None:
        """Write the header, which programs read before they read a table."""
        connection.exec_driver_sql(f"PRAGMA user_version = {SCHEMA}")
        connection.exec_driver_sql(f"PRAGMA application_id = {APPLICATION}")

    def advice(self, error: DBAPIError) -> str:
        """Advice by the error code."""
        if self.is_full(error):
            return _ADVICE[sqlite3.SQLITE_FULL]
        return _ADVICE.get(_code(error), "Check the disk and the folder of the file.")

    def is_full(self, error: DBAPIError) -> bool:
        """Whether the disk of the file is full."""
        return _code(error) == sqlite3.SQLITE_FULL or (_code(error) == sqlite3.SQLITE_READONLY and self._has_no_room)


@lru_cache(maxsize=1)
def in_memory_engine() -> Engine:
    """An engine whose connections have a database in memory each."""
    return create_engine("sqlite://", poolclass=NullPool)


@lru_cache(maxsize=8)
def _read_only_engine(file: Path) -> Engine:
    """The engine of a file that no process writes: SQLite then needs no files beside it."""
    address = f"{file.absolute().as_uri()}?mode=ro&immutable=1"

    def connect() -> sqlite3.Connection:
        return sqlite3.connect(address, uri=True, isolation_level=None)

    return create_engine("sqlite://", creator=connect, poolclass=NullPool)


@lru_cache(maxsize=8)
def _engine(file: str) -> Engine:
    """The engine of a file, which keeps compiled statements and connections."""

    def connect() -> sqlite3.Connection:
        return sqlite3.connect(file, timeout=REGISTRY_SECONDS, isolation_level=None, check_same_thread=False)

    engine = create_engine("sqlite://", creator=connect, poolclass=QueuePool, max_overflow=-1)

    @event.listens_for(engine, "connect")
    def opened(connection: sqlite3.Connection, record: Any) -> None:
        connection.execute("PRAGMA foreign_keys = ON")
        connection.execute("PRAGMA synchronous = FULL")
        connection.execute("PRAGMA user_version")  # opens the file
        record.info["file"] = _identity(file)

    @event.listens_for(engine, "checkout")
    def used(_connection: sqlite3.Connection, record: Any, _proxy: Any) -> None:
        if record.info["file"] != _identity(file):
            raise DisconnectionError("another file has the name now")

    _OPEN.append(engine)
    return engine


_OPEN: list[Engine] = []


def close_all() -> None:
    """Close connections that are not in use. SQLite allows none of them in a process that is forked."""
    for engine in _OPEN:
        engine.dispose()


os.register_at_fork(before=close_all)
atexit.register(close_all)


@contextmanager
def new_file(file: Path) -> Iterator[Path]:
    """A file for a database, which gets its name when the block ends without an error. Raises RegistryUnusable."""
    with TemporaryDirectory(prefix=f".{file.name}.", dir=file.parent) as folder:
        part = Path(folder, file.name)
        yield part
        close_all()
        try:
            file.hardlink_to(part)
        except FileExistsError:
            message = "The registry must be empty to import another one."
            raise unusable(codes.REGISTRY_UNUSABLE.finding(message, str(file), fix="Name a new `database`.")) from None


def _size(file: Path) -> int:
    """Bytes of a file; 0 if it does not exist."""
    return file.stat().st_size if file.exists() else 0


def _identity(file: str) -> tuple[int, int] | None:
    try:
        found = Path(file).stat()
    except OSError:
        return None
    return found.st_dev, found.st_ino


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


def _use_wal(connection: Connection, seconds: float) -> None:
    """Switch the journal. SQLite refuses this at once while others are connected, so it is tried again."""
    end = time.monotonic() + seconds
    while True:
        try:
            connection.exec_driver_sql("PRAGMA journal_mode = WAL")
        except DBAPIError as error:
            if _code(error) != sqlite3.SQLITE_BUSY or time.monotonic() > end:
                raise
            time.sleep(0.01)
        else:
            return


def _header(connection: Connection) -> tuple[int, int]:
    """The schema and the number of the application."""
    schema, application = connection.exec_driver_sql(_HEADER).one()
    return schema, application


def _has_tables(connection: Connection) -> bool:
    return bool(connection.exec_driver_sql("SELECT count(*) FROM sqlite_master").scalar_one())


def _code(error: DBAPIError) -> int:
    return int(getattr(error.orig, "sqlite_errorcode", 0)) & _PRIMARY
