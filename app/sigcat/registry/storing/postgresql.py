"""A registry in a PostgreSQL database, which several machines share."""

import atexit
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache
from typing import NamedTuple

from sqlalchemy import URL, Connection, Engine, create_engine, make_url, text
from sqlalchemy.exc import ArgumentError, DBAPIError

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
            connection.execute(text(f"SET LOCAL lock_timeout = '{seconds * 1000:.0f}ms'"))
            connection.execute(text("SET LOCAL synchronous_commit = on"))
            connection.execute(text(f"SELECT pg_advisory_xact_lock({APPLICATION})"))
            yield

    @contextmanager
    def snapshot(self, connection: Connection) -> Iterator[None]:
        """A transaction that reads."""
        with connection.begin():
            connection.execute(text("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ, READ ONLY"))
            yield

    def schema(self, connection: Connection) -> int:
        """The revision of Alembic."""
        if connection.execute(text("SELECT to_regclass('alembic_version')")).scalar() is None:
            return 0
        revisions = connection.execute(text("SELECT version_num FROM alembic_version")).scalars().all()
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


@lru_cache(maxsize=8)
def _engine(url: ServerUrl) -> Engine:
    options = {"connect_timeout": _CONNECT_SECONDS, "application_name": "sigcat"}
    engine = create_engine(_url(url), pool_pre_ping=True, max_overflow=-1, connect_args=options)
    # a forked process would share the connection, and its server process with it
    os.register_at_fork(before=engine.dispose)
    atexit.register(engine.dispose)
    return engine
