"""Entries of the log as events of CloudEvents 1.0."""

import json
from collections.abc import Mapping
from typing import Any

from sqlalchemy import Connection, select

from sigcat.limits import REGISTRY_ROWS
from sigcat.registry.reference import unknown
from sigcat.registry.storing.entry import Entry, Link
from sigcat.registry.storing.ledger import log_page
from sigcat.registry.storing.tables import LOG

_PREFIX = "io.sigcat.registry."
_BY_STATE = {"draft": "drafted", "pending": "pending", "published": "published", "deprecated": "deprecated", "retired": "retired"}  # fmt: skip
_BY_ACTION = {
    "rule": "rule-set", "deployment": "deployed", "release": "released", "support ended": "support-ended",
    "approve": "approved", "reject": "rejected", "acknowledge": "acknowledged",
}  # fmt: skip
TYPES = tuple(f"{_PREFIX}{name}" for name in (*_BY_STATE.values(), *_BY_ACTION.values()))
"""All types of events."""

Event = Mapping[str, Any]


def events_after(connection: Connection, number: int) -> tuple[Event, ...]:
    """Events of the entries behind one, in order; of many, the first ones."""
    source = source_of(connection)
    return tuple(event_of(link, source) for link in log_page(connection, number, REGISTRY_ROWS))


def event_of(link: Link, source: str) -> Event:
    """The event of an entry. Its id is the hash of the entry, so that it never changes."""
    entry = link.entry
    return {
        "specversion": "1.0",
        "id": link.hash,
        "source": source,
        "type": type_of(entry),
        "subject": _subject(entry.data),
        "time": entry.at,
        "datacontenttype": "application/json",
        "sequence": f"{link.number:010}",
        "data": dict(entry.data),
    }


def type_of(entry: Entry) -> str:
    """The type of the event of an entry."""
    return f"{_PREFIX}{event_name(entry)}"


def event_name(entry: Entry) -> str:
    """The end of the type of the event of an entry, such as `published`."""
    return _BY_STATE[entry.data["state"]] if entry.action in ("publish", "state") else _BY_ACTION[entry.action]


def _subject(data: Mapping[str, Any]) -> str:
    return f"{data['name']}@{data['version']}" if "version" in data else str(data["name"])


def source_of(connection: Connection) -> str:
    """The source of events: the log, which its first entry identifies, also after an import."""
    first = connection.execute(select(LOG.c.hash).order_by(LOG.c.number).limit(1)).scalar()
    return f"/sigcat/registry/{(first or '')[:16]}"


def number_of_event(connection: Connection, event_id: str) -> int:
    """The number of the entry of an event; 0 without an id. Raises InputRefused."""
    if not event_id:
        return 0
    number: int | None = connection.execute(select(LOG.c.number).where(LOG.c.hash == event_id)).scalar()
    if number is None:
        raise unknown("event", event_id, ())
    return number


def event_text(event: Event) -> str:
    """The event as one line of JSON."""
    return json.dumps(event, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
