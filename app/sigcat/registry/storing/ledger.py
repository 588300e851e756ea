"""Write to the registry: content by its digest, and entries that change the tables."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from sqlalchemy import Connection, insert, select

from sigcat.digest import digest_of
from sigcat.limits import REGISTRY_ROWS
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.entry import BEGIN, Action, Entry, Link, linked, now
from sigcat.registry.storing.replay import apply
from sigcat.registry.storing.tables import CONTENTS, LOG


class Registry(NamedTuple):
    """The place of a registry."""

    database: Path
    key: Path | None = None
    """Private key that signs the log."""


class Ledger(NamedTuple):
    """A transaction that writes."""

    connection: Connection
    key: Path | None

    def put(self, data: bytes) -> str:
        """Store content, and return its digest."""
        digest = digest_of(data)
        if self.connection.execute(select(CONTENTS.c.digest).where(CONTENTS.c.digest == digest)).first() is None:
            self.connection.execute(insert(CONTENTS).values(digest=digest, data=data))
        return digest

    def append(self, action: Action, data: Mapping[str, Any]) -> None:
        """Write an entry behind the last one, and change the tables."""
        last = head(self.connection)
        entry = Entry(last.number + 1 if last else 1, now(), action, data)
        self._write(linked(entry, last.hash if last else BEGIN))

    def _write(self, link: Link) -> None:
        signed = link._replace(signature=self._signature(link.hash))
        self.connection.execute(insert(LOG).values(**signed._asdict()))
        apply(self.connection, link.entry)

    def _signature(self, text: str) -> str:
        if self.key is None:
            return ""
        from sigcat.registry.storing.signing import signature_of

        return signature_of(text, self.key)


@contextmanager
def ledger_of(registry: Registry) -> Iterator[Ledger]:
    """One transaction: all of its entries are written, or none."""
    with writing(registry.database) as connection:
        yield Ledger(connection, registry.key)


def head(connection: Connection) -> Link | None:
    """The last entry of the log."""
    row = connection.execute(select(LOG).order_by(LOG.c.number.desc()).limit(1)).first()
    return Link(*row) if row is not None else None


def links_after(connection: Connection, number: int) -> tuple[Link, ...]:
    """Entries behind one, in order: at most so many as an answer has."""
    chosen = select(LOG).where(LOG.c.number > number).order_by(LOG.c.number).limit(REGISTRY_ROWS)
    return tuple(Link(*row) for row in connection.execute(chosen))
