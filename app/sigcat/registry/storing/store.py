"""The requirements of a database that a registry is stored in."""

from contextlib import AbstractContextManager
from typing import Protocol

from sqlalchemy import Connection
from sqlalchemy.exc import DBAPIError


class Store(Protocol):
    """A database with transactions."""

    @property
    def name(self) -> str:
        """The name in findings, without a password."""

    def exists(self) -> bool:
        """Whether there is a database to read."""

    def connected(self) -> AbstractContextManager[Connection]:
        """A connection outside of any transaction."""

    def exclusive(self, connection: Connection, seconds: float) -> AbstractContextManager[object]:
        """A transaction that writes. It begins when those of other writers have ended, within so many seconds."""

    def snapshot(self, connection: Connection) -> AbstractContextManager[object]:
        """A transaction that reads one state."""

    def schema(self, connection: Connection) -> int:
        """The schema, 0 of a new database. Refuses a database of another program."""

    def set_schema(self, connection: Connection) -> None:
        """Record that the database has the schema of this program."""

    def advice(self, error: DBAPIError) -> str:
        """Return what to do about an error."""

    def is_full(self, error: DBAPIError) -> bool:
        """Whether its disk is full."""
