"""Published versions and vehicle lines, as the tables have them."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from sqlalchemy import Connection, Select, select

from sigcat.registry.reference import DEPLOYABLE, Kind, Reference, Rule, State, unknown
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
    """Date after which a deprecated version may be retired."""
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


class Running(NamedTuple):
    """A version in a vehicle line, since a time."""

    line: str
    since: str
    published: Published


_COLUMNS = (
    VERSIONS.c.id, NAMES.c.kind, NAMES.c.name, NAMES.c.rule, VERSIONS.c.version, VERSIONS.c.state, VERSIONS.c.owner,
    VERSIONS.c.content, VERSIONS.c.resolved, VERSIONS.c.uses, VERSIONS.c.at, VERSIONS.c.until, VERSIONS.c.successor,
)  # fmt: skip


def all_versions(connection: Connection, kind: Kind | None = None, name: str | None = None) -> tuple[Published, ...]:
    """Versions by kind, name and precedence."""
    chosen = select(*_COLUMNS).join(NAMES)
    if kind is not None:
        chosen = chosen.where(NAMES.c.kind == kind)
    if name is not None:
        chosen = chosen.where(NAMES.c.name == name)
    return _versions(connection, chosen)


def version_named(connection: Connection, kind: Kind, reference: Reference) -> Published:
    """The version of a reference. Raises InputRefused with near names."""
    versions = all_versions(connection, kind, reference.name)
    if not versions:
        raise unknown(kind, reference.name, names_of(connection, kind))
    found = next((each for each in versions if each.version == reference.version), None)
    if found is None:
        raise unknown(f"version of {reference.name}", reference.version, [each.version for each in versions])
    return found


def names_of(connection: Connection, kind: Kind) -> tuple[str, ...]:
    """Names of a kind, in order."""
    return tuple(connection.execute(select(NAMES.c.name).where(NAMES.c.kind == kind).order_by(NAMES.c.name)).scalars())


def running(connection: Connection, line: str | None = None) -> tuple[Running, ...]:
    """Versions that vehicles run: of a line, or of all lines, in order."""
    lines = NAMES.alias("lines")
    chosen = (
        select(lines.c.name, DEPLOYMENTS.c.since, *_COLUMNS)
        .select_from(DEPLOYMENTS)
        .join(VERSIONS, VERSIONS.c.id == DEPLOYMENTS.c.version_id)
        .join(NAMES, NAMES.c.id == VERSIONS.c.name_id)
        .join(lines, lines.c.id == DEPLOYMENTS.c.line_id)
        .where(DEPLOYMENTS.c.until == "")
    )
    if line is not None:
        chosen = chosen.where(lines.c.name == line)
    rows = (Running(row[0], row[1], Published._make(row[2:])) for row in connection.execute(chosen))
    return tuple(sorted(rows, key=lambda each: (each.line, each.published.name, each.published.precedence.key)))


def current(connection: Connection) -> tuple[Published, ...]:
    """Versions of functions that matter: those in vehicles, and the newest published one of each name."""
    newest = {each.name: each for each in all_versions(connection, "function") if each.state in DEPLOYABLE}
    found = {each.id: each for each in (*newest.values(), *(each.published for each in running(connection)))}
    return tuple(sorted(found.values(), key=lambda each: (each.name, each.precedence.key)))


def lines_by_version(connection: Connection) -> Mapping[int, tuple[str, ...]]:
    """Vehicle lines in which each version runs."""
    found: dict[int, list[str]] = {}
    for each in running(connection):
        found.setdefault(each.published.id, []).append(each.line)
    return {version: tuple(lines) for version, lines in found.items()}


def _versions(connection: Connection, chosen: Select[tuple[object, ...]]) -> tuple[Published, ...]:
    return in_order(map(Published._make, connection.execute(chosen)))


def in_order(versions: Iterable[Published]) -> tuple[Published, ...]:
    """Versions by kind, name and precedence."""
    return tuple(sorted(versions, key=lambda each: (each.kind, each.name, each.precedence.key)))
