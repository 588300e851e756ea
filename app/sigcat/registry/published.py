"""Published versions and vehicle lines, as the tables have them."""

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from sqlalchemy import Connection, bindparam, exists, select

from sigcat import codes
from sigcat.findings import shown
from sigcat.registry.reference import Kind, Reference, Rule, State, refused, unknown
from sigcat.registry.storing.entry import is_past
from sigcat.registry.storing.replay import portions
from sigcat.registry.storing.tables import DEPLOYMENTS, NAMES, VERSIONS
from sigcat.registry.version import Version, version_of


class Published(NamedTuple):
    """A version of a name."""

    id: int
    kind: Kind
    name: str
    rule: Rule
    version: str
    state: State
    owner: str
    content: str
    """Digest of the file."""
    resolved: str
    """Digest of the Function JSON; of an overlay and a catalogue, of its nodes."""
    uses: str
    """Digest of the uses."""
    at: str
    until: str
    """Last day of the support of a deprecated version."""
    successor: str

    @property
    def reference(self) -> Reference:
        """The version as commands name it."""
        return Reference(self.name, self.version)

    @property
    def precedence(self) -> Version:
        """The version in the order of SemVer."""
        found = version_of(self.version)
        assert found is not None
        return found

    @property
    def is_unsupported(self) -> bool:
        """Whether the support of a deprecated version has ended."""
        return self.state == "deprecated" and is_past(self.until)

    @property
    def end(self) -> str:
        """The end of the support and the successor, as they follow the state in a sentence."""
        until = (
            f", support ended on {self.until}" if self.is_unsupported else f" until {self.until}" if self.until else ""
        )
        return until + (f", successor {self.successor}" if self.successor else "")


class Running(NamedTuple):
    """A version in a vehicle line, since a time."""

    line: str
    since: str
    published: Published


COLUMNS = (
    VERSIONS.c.id, NAMES.c.kind, NAMES.c.name, NAMES.c.rule, VERSIONS.c.version, VERSIONS.c.state, VERSIONS.c.owner,
    VERSIONS.c.content, VERSIONS.c.resolved, VERSIONS.c.uses, VERSIONS.c.at, VERSIONS.c.until, VERSIONS.c.successor,
)  # fmt: skip


PUBLISHED = select(*COLUMNS).join(NAMES)
"""All versions."""
_BY_PRECEDENCE = (NAMES.c.kind, NAMES.c.name, VERSIONS.c.precedence, VERSIONS.c.id)
_IS_RUNNING = exists().where(DEPLOYMENTS.c.version_id == VERSIONS.c.id, DEPLOYMENTS.c.until == "").correlate(VERSIONS)
IS_CURRENT = (NAMES.c.kind == "function") & ((VERSIONS.c.id == NAMES.c.newest) | _IS_RUNNING)
"""Versions of functions that matter: those in vehicles, and the newest published one of each name."""

_BY_ID = PUBLISHED.where(VERSIONS.c.id.in_(bindparam("ids", expanding=True)))
_CURRENT_BY_ID = _BY_ID.where(IS_CURRENT)
_LINES = (
    select(DEPLOYMENTS.c.version_id, NAMES.c.name).join(NAMES, NAMES.c.id == DEPLOYMENTS.c.line_id)
    .where(DEPLOYMENTS.c.until == "").order_by(NAMES.c.name)
)  # fmt: skip
_LINES_BY_ID = _LINES.where(DEPLOYMENTS.c.version_id.in_(bindparam("ids", expanding=True)))


_SHOWN = 5
"""Versions that a message names."""


def all_versions(connection: Connection, kind: Kind | None = None, name: str | None = None) -> tuple[Published, ...]:
    """Versions by kind, name and precedence."""
    chosen = PUBLISHED.order_by(*_BY_PRECEDENCE)
    if kind is not None:
        chosen = chosen.where(NAMES.c.kind == kind)
    if name is not None:
        chosen = chosen.where(NAMES.c.name == name, NAMES.c.folded == name.casefold())
    return tuple(map(Published._make, connection.execute(chosen)))


def version_named(connection: Connection, kind: Kind, reference: Reference) -> Published:
    """The version of a reference. Raises InputRefused with near names."""
    versions = all_versions(connection, kind, reference.name)
    if not versions:
        raise unknown(kind, reference.name, names_of(connection, kind))
    found = next((each for each in versions if each.version == reference.version), None)
    if found is None:
        message = f"The registry has no version {shown(reference.version)} of {reference.name}."
        newest = ", ".join(each.version for each in versions[-_SHOWN:])
        fix = f"Published versions are {newest}." if len(versions) <= _SHOWN else f"The newest versions are {newest}."
        raise refused(codes.NOT_PUBLISHED.finding(message, path=reference.name, fix=fix))
    return found


def names_of(connection: Connection, kind: Kind) -> tuple[str, ...]:
    """Names of a kind, in order."""
    return tuple(connection.execute(select(NAMES.c.name).where(NAMES.c.kind == kind).order_by(NAMES.c.name)).scalars())


def running(connection: Connection, line: str | None = None) -> tuple[Running, ...]:
    """Versions that vehicles run: of a line, or of all lines, in order."""
    lines = NAMES.alias("lines")
    chosen = (
        select(lines.c.name, DEPLOYMENTS.c.since, *COLUMNS)
        .select_from(DEPLOYMENTS)
        .join(VERSIONS, VERSIONS.c.id == DEPLOYMENTS.c.version_id)
        .join(NAMES, NAMES.c.id == VERSIONS.c.name_id)
        .join(lines, lines.c.id == DEPLOYMENTS.c.line_id)
        .where(DEPLOYMENTS.c.until == "")
    )
    if line is not None:
        chosen = chosen.where(lines.c.kind == "line", lines.c.folded == line.casefold(), lines.c.name == line)
    chosen = chosen.order_by(lines.c.name, NAMES.c.name, VERSIONS.c.precedence, DEPLOYMENTS.c.id)
    return tuple(Running(row[0], row[1], Published._make(row[2:])) for row in connection.execute(chosen))


def current(connection: Connection) -> tuple[Published, ...]:
    """Versions of functions that matter: those in vehicles, and the newest published one of each name."""
    return tuple(map(Published._make, connection.execute(PUBLISHED.where(IS_CURRENT).order_by(*_BY_PRECEDENCE))))


def published_by_id(
    connection: Connection, ids: Iterable[int], *, is_complete: bool = False
) -> Mapping[int, Published]:
    """Versions by their ids, in order of name and precedence. `is_complete`: also those that do not matter."""
    chosen = _BY_ID if is_complete else _CURRENT_BY_ID
    rows = (row for part in portions(sorted(set(ids))) for row in connection.execute(chosen, {"ids": part}))
    found = list(map(Published._make, rows))
    return {each.id: each for each in sorted(found, key=lambda each: (each.name, each.precedence.key))}


def lines_by_version(connection: Connection, ids: Iterable[int] | None = None) -> Mapping[int, tuple[str, ...]]:
    """Vehicle lines in which versions run: some of them, or all."""
    if ids is None:
        rows: Iterable[Any] = connection.execute(_LINES)
    else:
        parts = portions(sorted(set(ids)))
        rows = (row for part in parts for row in connection.execute(_LINES_BY_ID, {"ids": part}))
    found: dict[int, list[str]] = {}
    for version, line in rows:
        found.setdefault(version, []).append(line)
    return {version: tuple(lines) for version, lines in found.items()}
