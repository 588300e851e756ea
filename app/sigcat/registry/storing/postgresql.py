"""A registry in a PostgreSQL database, which several machines share."""

import atexit
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache, partial
from time import monotonic
from typing import Any, NamedTuple

from sqlalchemy import URL, Connection, Dialect, Engine, create_engine, event, make_url, text
from sqlalchemy.exc import ArgumentError, DBAPIError, InvalidatePoolError

from sigcat import codes
from sigcat.project.project import ServerUrl
from sigcat.registry.reference import unusable
from sigcat.registry.storing.tables import APPLICATION

_CONNECT_SECONDS = 10
_URL = "postgresql://USER@HOST/NAME"
_ADVICE: Mapping[str, str] = {
    "": f"Start the server, or correct `database` in [registry]: {_URL}.",
    "42": "Use a separate database, whose user may create tables.",
    "53": "Free space on the disk of the server, or raise its limit of connections.",
    "55": "Run the command again.",
    "57": "Run the command again when the server is there.",
}
"""Advice by the class of an SQLSTATE, which an error of the connection does not have."""


_LOCK = text(
    "SELECT set_config('lock_timeout', :wait, true), set_config('synchronous_commit', 'on', true),"
    f" pg_advisory_xact_lock({APPLICATION})"
)
"""One question of three to the server: the settings act at once, in the order of the list."""
_REVISIONS = text("SELECT version_num FROM alembic_version")
_HAS_TABLES, _USED = "has tables", "time of last use"
"""Facts about a connection, which need no question to the server."""
_FRESH_SECONDS = 0.05
"""Time within which no server ends and starts again."""


class PostgresqlStore(NamedTuple):
    """The database of a URL."""

    url: ServerUrl

    @property
    def name(self) -> str:
        """The URL without its password."""
        return str(self.url)

    def exists(self) -> bool:
        """Whether it exists, which only the server knows."""
        return True

    @contextmanager
    def connected(self) -> Iterator[Connection]:
        """A connection, which the process keeps; one that the server has closed is replaced."""
        with _engine(self.url).connect() as connection:
            yield connection

    @contextmanager
    def exclusive(self, connection: Connection, seconds: float) -> Iterator[None]:
        """A transaction that writes. Each of its statements sees what writers before it committed."""
        with connection.begin():
            connection.execute(_LOCK, {"wait": f"{seconds * 1000:.0f}ms"})
            yield

    @contextmanager
    def snapshot(self, connection: Connection) -> Iterator[None]:
        """A transaction that reads."""
        with connection.begin():
            connection.execute(text("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ, READ ONLY"))
            yield

    def schema(self, connection: Connection) -> int:
        """The revision of Alembic."""
        if not connection.info.get(_HAS_TABLES):
            if connection.execute(text("SELECT to_regclass('alembic_version')")).scalar() is None:
                return 0
            connection.info[_HAS_TABLES] = True
        revisions = connection.execute(_REVISIONS).scalars().all()
        if len(revisions) != 1 or not revisions[0].isdecimal():
            message, fix = "The database belongs to another program.", "Create a database for the registry alone."
            raise unusable(codes.REGISTRY_UNUSABLE.finding(message, self.name, fix=fix))
        return int(revisions[0])

    def set_schema(self, connection: Connection) -> None:
        """The revision is in its table already."""

    def advice(self, error: DBAPIError) -> str:
        """Advice by the class of the error."""
        state = getattr(error.orig, "sqlstate", None) or ""
        return _ADVICE.get(state[:2], "Read the log of the server.")

    def is_full(self, error: DBAPIError) -> bool:
        """Whether the disk of the server is full."""
        return getattr(error.orig, "sqlstate", None) == "53100"


def _url(url: ServerUrl) -> URL:
    try:
        return make_url(url.text).set(drivername="postgresql+psycopg")
    except (ArgumentError, ValueError):
        message = "The URL of the database cannot be read."
        fix = f"Write it such as {_URL} in [registry]."
        raise unusable(codes.REGISTRY_UNUSABLE.finding(message, fix=fix)) from None


def _returned(_connection: Any, record: Any) -> None:
    record.info[_USED] = monotonic()


def _taken(dialect: Dialect, connection: Any, record: Any, _proxy: Any) -> None:
    """Ask the server whether it still has a connection; one that was used just now needs no question."""
    if monotonic() - record.info.get(_USED, 0) < _FRESH_SECONDS:
        return
    try:
        dialect.do_ping(connection)
    except dialect.loaded_dbapi.Error as error:
        raise InvalidatePoolError from error  # all of its connections are replaced


@lru_cache(maxsize=8)
def _engine(url: ServerUrl) -> Engine:
    options = {"connect_timeout": _CONNECT_SECONDS, "application_name": "sigcat"}
    engine = create_engine(_url(url), max_overflow=-1, connect_args=options)
    event.listen(engine, "checkin", _returned)
    event.listen(engine, "checkout", partial(_taken, engine.dialect))
    # a forked process would share the connection, and its server process with it
    os.register_at_fork(before=engine.dispose)
    atexit.register(engine.dispose)
    return engine
