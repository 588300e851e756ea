"""The registry, ready to be shown: names, versions, users of a signal, and what may be deployed where.

Importing this loads SQLAlchemy, which is an extra.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeVar
from urllib.parse import urlsplit

from sigcat.errors import NotFound
from sigcat.integration.grouping import grouped
from sigcat.names import nearest
from sigcat.registry.access.access import Listed
from sigcat.registry.changes import UseChange, function_changes
from sigcat.registry.compatibility.conflicts import Conflict
from sigcat.registry.compatibility.deploying import Decision, can_deploy
from sigcat.registry.compatibility.member import Member
from sigcat.registry.decisions.acknowledgements import Deprecation, deprecations
from sigcat.registry.decisions.approvals import Pending, pending
from sigcat.registry.events import event_name
from sigcat.registry.published import Published, all_versions, lines_by_version, names_of, running
from sigcat.registry.reference import DEPLOYABLE, KIND_OF
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import Snapshot
from sigcat.registry.storing.entry import Entry, now
from sigcat.registry.storing.ledger import last_number, log_page
from sigcat.registry.use import from_json
from sigcat.registry.webhooks.deliveries import count_deliveries, deliveries

Found = TypeVar("Found")
ENTRIES = 30
"""Entries of the log on the first page."""
_NAMES = 120
"""Names on one page."""
_DELIVERIES = 100
"""Deliveries on the page."""
_FUNCTIONS, _LINES = 20, 8
"""Rows and columns of the matrix."""


class NameRow(NamedTuple):
    """A published name."""

    newest: Published
    versions: int
    lines: tuple[str, ...]
    """Vehicle lines in which any of its versions runs."""


class RegistryView(NamedTuple):
    """The first page."""

    names: tuple[NameRow, ...]
    start: int
    following: int
    """First name of the next page; 0 on the last."""
    name_total: int
    entries: tuple[tuple[Entry, str], ...]
    """The last entries of the log with the names of their events, the newest first."""
    entry_total: int
    lines: tuple[str, ...]
    pending: tuple[Pending, ...]
    """Versions that wait for approvals, the newest first."""
    deprecations: tuple[Deprecation, ...]
    """Deprecated versions that other owners use, the newest first."""
    now: str

    @property
    def previous(self) -> int:
        """First name of the page before."""
        return max(self.start - _NAMES, 0)


class DeliveryRow(NamedTuple):
    """An event for a webhook."""

    id: str
    type: str
    subject: str
    host: str
    state: str
    attempts: int
    answer: str


class DeliveriesView(NamedTuple):
    """The newest deliveries, and the number of all."""

    deliveries: tuple[DeliveryRow, ...]
    total: int


class NameView(NamedTuple):
    """All versions of a name, the newest first, and the changes between two of them."""

    versions: tuple[Listed, ...]
    old: str
    new: str
    changes: tuple[UseChange, ...]


class Cell(NamedTuple):
    """A function in a vehicle line."""

    runs: tuple[Published, ...]
    """Versions that run."""
    newest: str
    """The version that was checked; empty if it runs already, or nothing is published."""
    decision: Decision | None
    conflicts: tuple[Conflict, ...]


class MatrixRow(NamedTuple):
    """A function, and its cells by line."""

    name: str
    owner: str
    newest: str
    cells: tuple[Cell, ...]


class MatrixView(NamedTuple):
    """Functions and vehicle lines."""

    lines: tuple[str, ...]
    rows: tuple[MatrixRow, ...]
    start: int
    following: int
    """First row of the next page; 0 on the last."""
    total: int
    line_total: int

    @property
    def previous(self) -> int:
        """First row of the page before."""
        return max(self.start - _FUNCTIONS, 0)


def deliveries_view(connection: Snapshot, state: str) -> DeliveriesView:
    """Return the newest deliveries of webhooks. Of an address only the host is shown: the rest may be a secret."""
    found = deliveries(connection, state)[::-1][:_DELIVERIES]
    rows = tuple(
        DeliveryRow(
            each.id, each.event["type"].rpartition(".")[2], each.event["subject"], urlsplit(each.url).hostname or "",
            each.state, each.attempts, each.answer,
        )
        for each in found
    )  # fmt: skip
    return DeliveriesView(rows, count_deliveries(connection, state))


def registry_view(connection: Snapshot, start: int) -> RegistryView:
    """Return the names with their newest versions, and the last entries of the log."""
    versions = all_versions(connection)
    lines = lines_by_version(connection)
    rows = tuple(_name_rows(versions, lines))
    number = last_number(connection)
    entries = tuple(
        (each.entry, event_name(each.entry)) for each in log_page(connection, max(0, number - ENTRIES), ENTRIES)
    )
    following = start + _NAMES if start + _NAMES < len(rows) else 0
    shown = rows[start : start + _NAMES]
    lines_of_vehicles = names_of(connection, "line")
    waiting = pending(connection)[::-1]
    ending = tuple(each for each in deprecations(connection) if each.acknowledgements)[::-1]
    return RegistryView(
        shown, start, following, len(rows), entries[::-1], number, lines_of_vehicles, waiting, ending, now()
    )


def _name_rows(versions: Iterable[Published], lines: Mapping[int, tuple[str, ...]]) -> Iterator[NameRow]:
    for found in grouped(versions, lambda each: (each.kind, each.name)).values():
        where = sorted({line for each in found for line in lines.get(each.id, ())})
        yield NameRow(_newest(found) or found[-1], len(found), tuple(where))


def _newest(versions: Sequence[Published]) -> Published | None:
    """The newest version that vehicles may run."""
    return next((each for each in reversed(versions) if each.state in DEPLOYABLE), None)


def name_view(connection: Snapshot, group: str, name: str, old: str = "", new: str = "") -> NameView:
    """Return the versions of a name. Without two versions given, the last two are compared. Raises NotFound."""
    kind = _known("kind", group, KIND_OF)
    versions = all_versions(connection, kind, name)
    if not versions:
        raise NotFound(f"Unknown {kind} {name[:100]!r}.", nearest(name[:100], names_of(connection, kind)))
    by_version = {each.version: each for each in versions}
    for each in filter(None, (old, new)):
        _known("version", each, by_version)
    new = new or versions[-1].version
    old = old or versions[max(0, len(versions) - 2)].version
    lines = lines_by_version(connection)
    rows = tuple(Listed(each, lines.get(each.id, ())) for each in reversed(versions))
    changes = _changes(connection, by_version[old], by_version[new]) if kind == "function" and old != new else ()
    return NameView(rows, old, new, tuple(changes))


def _known(what: str, name: str, known: Mapping[str, Found]) -> Found:
    if name not in known:
        raise NotFound(f"Unknown {what} {name[:100]!r}.", nearest(name[:100], known))
    return known[name]


def _changes(connection: Snapshot, old: Published, new: Published) -> Iterator[UseChange]:
    before, after = (from_json(content_of(connection, each.uses)) for each in (old, new))
    return function_changes(before, after)


def matrix_view(connection: Snapshot, start: int) -> MatrixView:
    """Return which versions run in each line, and whether the newest one may be deployed there."""
    by_name = grouped(all_versions(connection, "function"), lambda each: each.name)
    lines = names_of(connection, "line")
    runs: dict[tuple[str, str], list[Published]] = {}
    for one in running(connection):
        runs.setdefault((one.published.name, one.line), []).append(one.published)
    shown = list(by_name.items())[start : start + _FUNCTIONS]
    known: dict[int, Member] = {}
    rows = tuple(_matrix_row(connection, versions, lines[:_LINES], runs, known) for _, versions in shown)
    following = start + _FUNCTIONS if start + _FUNCTIONS < len(by_name) else 0
    return MatrixView(lines[:_LINES], rows, start, following, len(by_name), len(lines))


def _matrix_row(
    connection: Snapshot,
    versions: Sequence[Published],
    lines: Sequence[str],
    runs: Mapping[tuple[str, str], list[Published]],
    known: dict[int, Member],
) -> MatrixRow:
    newest = _newest(versions)
    named = newest or versions[-1]
    cells = (_cell(connection, newest, line, runs.get((named.name, line), ()), known) for line in lines)
    return MatrixRow(named.name, named.owner, newest.version if newest else "", tuple(cells))


def _cell(
    connection: Snapshot, newest: Published | None, line: str, runs: Sequence[Published], known: dict[int, Member]
) -> Cell:
    if newest is None or newest in runs:
        return Cell(tuple(runs), "", None, ())
    answer = can_deploy(connection, [newest.reference], line, known)
    return Cell(tuple(runs), newest.version, answer.decision, answer.conflicts)
