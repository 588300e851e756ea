"""Write to the registry: content by its digest, and entries that change the tables."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from sqlalchemy import Connection, insert, select, text

from sigcat.digest import digest_of
from sigcat.limits import REGISTRY_SECONDS
from sigcat.registry.author import ANYONE, Author
from sigcat.registry.storing.database import Place, writing
from sigcat.registry.storing.entry import BEGIN, Action, Entry, Link, linked, now
from sigcat.registry.storing.replay import apply
from sigcat.registry.storing.tables import LOG


class Registry(NamedTuple):
    """The place of a registry, and who writes to it."""

    database: Place
    key: Path | None = None
    """Private key that signs the log."""
    author: Author = ANYONE
    seconds: float = REGISTRY_SECONDS
    """Time to wait until others have written."""


class Ledger:
    """A transaction that writes. Nobody else writes meanwhile, so it knows the last entry."""

    def __init__(self, connection: Connection, key: Path | None, author: Author = ANYONE) -> None:
        self.connection = connection
        self.author = author
        self._key = key

    @cached_property
    def head(self) -> Link | None:
        """The last entry of the log."""
        return head(self.connection)

    @property
    def head_hash(self) -> str:
        """The hash of the last entry; empty without one."""
        return self.head.hash if self.head else ""

    def put(self, *contents: bytes) -> tuple[str, ...]:
        """Store contents, and return their digests."""
        digests = tuple(map(digest_of, contents))
        rows = [{"digest": digest, "data": data} for digest, data in zip(digests, contents, strict=True)]
        self.connection.execute(_INSERT_CONTENT, rows)
        return digests

    def append(self, action: Action, data: Mapping[str, Any]) -> None:
        """Write an entry behind the last one, and change the tables."""
        last = self.head
        entry = Entry(last.number + 1 if last else 1, now(), action, {**data, **self.author.entry_data})
        self._write(linked(entry, last.hash if last else BEGIN))

    def _write(self, link: Link) -> None:
        signed = link._replace(signature=self._signature(link.hash))
        self.connection.execute(_INSERT_LINK, signed._asdict())
        self.head = signed
        apply(self.connection, link.entry)

    def _signature(self, text: str) -> str:
        if self._key is None:
            return ""
        from sigcat.registry.storing.signing import signature_of

        return signature_of(text, self._key)


_INSERT_CONTENT = text("INSERT INTO contents (digest, data) VALUES (:digest, :data) ON CONFLICT (digest) DO NOTHING")
_INSERT_LINK = insert(LOG)
_HEAD = select(LOG).order_by(LOG.c.number.desc()).limit(1)


@contextmanager
def ledger_of(registry: Registry) -> Iterator[Ledger]:
    """One transaction: all of its entries are written, or none."""
    with writing(registry.database, registry.seconds) as connection:
        yield Ledger(connection, registry.key, registry.author)


def head(connection: Connection) -> Link | None:
    """The last entry of the log."""
    row = connection.execute(_HEAD).first()
    return Link(*row) if row is not None else None


def last_number(connection: Connection) -> int:
    """Number of the last entry of the log; 0 without one."""
    last = head(connection)
    return last.number if last else 0


def link_with(connection: Connection, digest: str) -> Link | None:
    """The entry with a hash."""
    row = connection.execute(select(LOG).where(LOG.c.hash == digest)).first()
    return Link(*row) if row is not None else None


def log_page(connection: Connection, after: int, most: int) -> tuple[Link, ...]:
    """Entries of the log in order, from behind a number on."""
    chosen = select(LOG).where(LOG.c.number > after).order_by(LOG.c.number).limit(most)
    return tuple(Link(*row) for row in connection.execute(chosen))
