"""Verify a registry: the chain of its log, signatures, content, and the tables that follow from the log."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sqlalchemy import Connection, LargeBinary, Table, cast, insert, select

from sigcat import codes
from sigcat.digest import digest_of
from sigcat.findings import Finding
from sigcat.registry.storing.database import in_memory
from sigcat.registry.storing.entry import BEGIN, Link, hash_of
from sigcat.registry.storing.replay import apply
from sigcat.registry.storing.tables import APPROVALS, CONTENTS, DEPLOYMENTS, LOG, NAMES, USES, VERSIONS

_DERIVED = (NAMES, VERSIONS, USES, DEPLOYMENTS, APPROVALS)
_MOST = 100
"""Findings; after the first of them, little is left to learn."""


class Verified(NamedTuple):
    """The result: findings, and what was checked."""

    findings: tuple[Finding, ...]
    entries: int
    head: str


def verify(connection: Connection, public: Path | None = None, head: str = "") -> Verified:
    """Check everything. `public`: key that signed the log. `head`: hash of an entry that must be in the log."""
    links = read_log(connection)
    findings = [*_chain(links), *_known(links, head), *_signatures(links, public), *_contents(connection, links)]
    if not findings:
        findings += _tables(connection, links)
    return Verified(tuple(findings[:_MOST]), len(links), links[-1].hash if links else "")


def read_log(connection: Connection) -> tuple[Link, ...]:
    """Return the entries of the log in order."""
    return tuple(Link(*row) for row in connection.execute(select(LOG).order_by(LOG.c.number)))


def _finding(message: str, path: str = "") -> Finding:
    fix = "Compare with a backup, and restore it."
    return codes.LOG_CHANGED.finding(message, path=path, fix=fix)


def _chain(links: Sequence[Link]) -> Iterator[Finding]:
    previous, expected = BEGIN, 1
    for link in links:
        for missing in range(expected, min(link.number, expected + _MOST)):
            yield _finding(f"Entry {missing} of the log is missing.", f"log/{missing}")
        written = _number_of(link)
        if written not in (link.number, None):
            yield _finding(
                f"Entry {link.number} of the log was swapped: it was written as {written}.", f"log/{link.number}"
            )
        elif written is None or link.hash != hash_of(link.previous, link.text):
            yield _finding(f"Entry {link.number} of the log was changed.", f"log/{link.number}")
        elif link.previous != previous and expected == link.number:
            yield _finding(f"Entry {link.number} of the log does not follow the one before it.", f"log/{link.number}")
        previous, expected = link.hash, link.number + 1


def _number_of(link: Link) -> int | None:
    """The number that the text of an entry has; None if it is not an entry."""
    try:
        number = link.entry.number
    except (ValueError, TypeError):
        return None
    return number if isinstance(number, int) else None


def _known(links: Sequence[Link], head: str) -> Iterator[Finding]:
    if head and head not in {link.hash for link in links}:
        yield _finding(
            "The log has no entry with the given hash: entries at its end are missing, or it is another log."
        )


def _signatures(links: Sequence[Link], public: Path | None) -> Iterator[Finding]:
    """Check the signatures of all entries that have one; the last one must have one."""
    if public is None:
        return
    from sigcat.registry.storing.signing import is_signed, public_key

    key = public_key(public)
    for link in links:
        if link.signature and not is_signed(link.hash, link.signature, key):
            yield _finding(f"The signature of entry {link.number} is not that of {public}.", f"log/{link.number}")
    if links and not links[-1].signature:
        yield _finding("The last entry of the log is not signed.", f"log/{links[-1].number}")


def _contents(connection: Connection, links: Sequence[Link]) -> Iterator[Finding]:
    """Check each content by its digest, and that all content that the log names is there."""
    known = set[str]()
    for digest, data in _stored(connection):
        known.add(digest)
        if digest_of(data) != digest:
            yield _finding(f"Content {digest[:16]} was changed.", f"content/{digest}")
    for link in links:
        for digest in _named_by(link) - known:
            message = f"Content {digest[:16]}, which entry {link.number} names, is missing."
            yield _finding(message, f"content/{digest}")


def _stored(connection: Connection) -> Iterator[tuple[str, bytes]]:
    """Yield content as bytes, also if it was replaced by a text."""
    chosen = select(CONTENTS.c.digest, cast(CONTENTS.c.data, LargeBinary)).order_by(CONTENTS.c.digest)
    return ((digest, data or b"") for digest, data in connection.execute(chosen))


def _named_by(link: Link) -> set[str]:
    try:
        data = link.entry.data
        return {str(data[key]) for key in ("content", "resolved", "uses") if key in data}
    except (ValueError, TypeError):
        return set()  # it has its finding


def _tables(connection: Connection, links: Sequence[Link]) -> Iterator[Finding]:
    """Compare the tables with those that the log makes again."""
    with in_memory() as again:
        for digest, data in _stored(connection):
            again.execute(insert(CONTENTS).values(digest=digest, data=data))
        try:
            for link in links:
                apply(again, link.entry)
        except Exception as error:  # noqa: BLE001 — content or a version that an entry names is gone, in whatever form
            yield _finding(
                f"The log cannot be applied again: content that it names is missing ({type(error).__name__})."
            )
            return
        for table in _DERIVED:
            yield from _differences(table, _rows(connection, table), _rows(again, table))


def _differences(table: Table, rows: Mapping[Any, Any], expected: Mapping[Any, Any]) -> Iterator[Finding]:
    for key in sorted(rows.keys() | expected.keys()):
        if rows.get(key) != expected.get(key):
            fault = "missing" if key not in rows else "not in the log" if key not in expected else "changed"
            row = rows.get(key) or expected[key]
            named = ", ".join(str(value)[:60] for value in row if value)
            yield _finding(f"A row of `{table.name}` is {fault}: {named}.", f"{table.name}/{key}")


def _rows(connection: Connection, table: Table) -> Mapping[Any, Any]:
    keys = len(table.primary_key.columns)
    return {tuple(row[:keys]): tuple(row) for row in connection.execute(select(table))}
