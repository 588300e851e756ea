"""Entries of the log: each has the hash of the one before it."""

import datetime as dt
import json
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

from sigcat.digest import digest_of

Action = Literal[
    "publish", "rule", "state", "deployment", "release", "support ended", "approve", "reject", "acknowledge"
]
BEGIN = "0" * 64
"""The hash before the first entry."""


class Entry(NamedTuple):
    """A change of the registry."""

    number: int
    """Position in the log, from 1 on."""
    at: str
    """Time in UTC, as the clock of the writer says it."""
    action: Action
    data: Mapping[str, Any]

    @property
    def text(self) -> str:
        """The entry as stable text."""
        return json.dumps(self._asdict(), sort_keys=True, separators=(",", ":"), ensure_ascii=False)


class Link(NamedTuple):
    """An entry in the chain."""

    number: int
    text: str
    previous: str
    hash: str
    signature: str = ""
    """Ed25519 over the hash, in hexadecimal; empty without a key."""

    @property
    def entry(self) -> Entry:
        """The entry that the text holds."""
        return Entry(**json.loads(self.text))


def time_text(moment: dt.datetime) -> str:
    """A time in UTC as entries have it; the texts are in the order of the times."""
    return moment.astimezone(dt.UTC).isoformat(timespec="milliseconds")


def now() -> str:
    """The present time as entries have it."""
    return time_text(dt.datetime.now(dt.UTC))


def is_past(day: str) -> bool:
    """Whether a day such as 2027-01-31 is over; an empty one never is."""
    return bool(day) and day < now()[:10]


def linked(entry: Entry, previous: str) -> Link:
    """The entry behind another one; not signed."""
    return Link(entry.number, entry.text, previous, hash_of(previous, entry.text))


def hash_of(previous: str, text: str) -> str:
    """The hash of an entry and of all entries before it."""
    return digest_of(f"{previous}\n{text}".encode())
