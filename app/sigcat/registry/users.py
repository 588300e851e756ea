"""Users of a path, directly and through errors, safety reactions and modes."""

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sqlalchemy import BindParameter, Connection, bindparam, select

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.limits import REGISTRY_ROWS
from sigcat.names import did_you_mean
from sigcat.registry.published import Published, all_versions, lines_by_version, published_by_id
from sigcat.registry.reference import Kind, refused
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.replay import portions
from sigcat.registry.storing.tables import RELIANCES, USES
from sigcat.registry.use import Use, from_row


class User(NamedTuple):
    """A use of an element by a version of a function."""

    published: Published
    use: Use
    through: tuple[str, ...]
    """Elements between the path and this use."""
    lines: tuple[str, ...]


class Users(NamedTuple):
    """Users of a path: at most so many as an answer shows."""

    users: tuple[User, ...]
    more: int


def users_of(connection: Connection, path: str, *, is_complete: bool = False) -> Users:
    """The users of a path, or of nodes below it. `is_complete`: also of versions that are neither newest nor in a line."""
    found = list(_reached(connection, path, is_complete=is_complete))
    shown = found[:REGISTRY_ROWS]
    lines = lines_by_version(connection, (each.published.id for each in shown))
    users = (each._replace(lines=lines.get(each.published.id, ())) for each in shown)
    return Users(tuple(users), len(found) - len(shown))


def users_in(connection: Connection, path: str, catalogue: Catalogue, *, is_complete: bool = False) -> Users:
    """The users of a path, or of the instances of a definition. Raises InputRefused if the path is unknown."""
    found = users_of(connection, path, is_complete=is_complete)
    return found if found.users else users_of_instances(connection, path, catalogue, is_complete=is_complete)


def users_of_instances(connection: Connection, path: str, catalogue: Catalogue, *, is_complete: bool = False) -> Users:
    """The users of the instances of a definition that a catalogue has. Raises InputRefused if the path is unknown."""
    instances = [node.path for node in catalogue.nodes.values() if node.template == path]
    each = [users_of(connection, instance, is_complete=is_complete) for instance in instances]
    users = tuple({(user.published.id, user.use[:5]): user for found in each for user in found.users}.values())
    if not users and not instances and path not in catalogue.nodes and not _is_published(connection, path):
        message = f"No published catalogue or function has {path[:200]!r}, nor has the catalogue of the project."
        fix = did_you_mean(path, catalogue.nodes) or "Search the catalogue: `sigcat search WORD`."
        raise refused(codes.NOT_PUBLISHED.finding(message, path=path, fix=fix))
    more = sum(found.more for found in each) + max(0, len(users) - REGISTRY_ROWS)
    return Users(users[:REGISTRY_ROWS], more)


def versions_with(connection: Connection, elements: Sequence[str]) -> frozenset[int]:
    """Versions that use any of these elements."""
    parts = portions(elements)
    return frozenset(
        version for part in parts for version in connection.execute(_WITH_ELEMENTS, {"names": part}).scalars()
    )


def direct_users(connection: Connection, elements: Sequence[str]) -> tuple[Published, ...]:
    """Current versions of functions that use one of these elements without providing it, in order."""
    rows = (row for row in _of_elements(connection, elements))
    versions = {row.version for row in rows if not from_row(row.text, row.relied).provides}
    return tuple(published_by_id(connection, versions).values())


def _is_published(connection: Connection, path: str) -> bool:
    """Whether any version has a path: a function that uses it or a node below, or a catalogue or an overlay with the node."""
    if next(_of_elements(connection, [path]), None) or connection.execute(_BELOW, _range(path)).first():
        return True
    versions = (version for kind in _WITH_NODES for version in all_versions(connection, kind))
    key = f"{json.dumps(path, ensure_ascii=False)}:".encode()
    return any(key in content_of(connection, resolved) for resolved in {version.resolved for version in versions})


_WITH_NODES: tuple[Kind, ...] = ("catalogue", "overlay")


def _range(path: str) -> Mapping[str, str]:
    return {"first": f"{path}.", "end": f"{path}/"}


class _Row(NamedTuple):
    """A row of `uses`, with what it relies on."""

    version: int
    number: int
    path: str
    element: str
    text: str
    relied: str | None


_COLUMNS = (USES.c.version_id, USES.c.number, USES.c.path, USES.c.element, USES.c.text, RELIANCES.c.relied)
_ROWS = select(*_COLUMNS).outerjoin(RELIANCES, RELIANCES.c.id == USES.c.reliance_id)
_BELOW = _ROWS.where(USES.c.path > bindparam("first"), USES.c.path < bindparam("end"))
"""Nodes below a branch: their paths are from `Branch.` on, before `Branch/`."""
_NAMED: BindParameter[str] = bindparam("names", expanding=True)
_OF_ELEMENTS = _ROWS.where(USES.c.path.in_(_NAMED) | USES.c.element.in_(_NAMED))
_WITH_ELEMENTS = select(USES.c.version_id).distinct().where(USES.c.element.in_(_NAMED))


def _reached(connection: Connection, path: str, *, is_complete: bool) -> Iterator[User]:
    """Users breadth first, without their lines: of the path, then of its consequences, each use once."""
    known: dict[int, Published] = {}
    level: Mapping[str, tuple[str, ...]] = {path: ()}
    seen, told = {path}, set[tuple[int, int]]()
    below = connection.execute(_BELOW, _range(path))
    rows = [_Row._make(row) for row in below]
    while level:
        rows += _of_elements(connection, list(level))
        known.update(published_by_id(connection, {row.version for row in rows} - known.keys(), is_complete=is_complete))
        following: dict[str, tuple[str, ...]] = {}
        for element, row in _in_order(rows, level, known):
            use, through = from_row(row.text, row.relied), level[element]
            if (row.version, row.number) not in told:
                told.add((row.version, row.number))
                yield User(known[row.version], use, through, ())
            for name in (use.element, *use.leads_to):
                if name not in seen and (name in use.leads_to or use.path == element):
                    seen.add(name)
                    following[name] = (*through, element) if name in use.leads_to else through
        level, rows = following, []


def _of_elements(connection: Connection, elements: Sequence[str]) -> Iterator[_Row]:
    for part in portions(elements):
        yield from map(_Row._make, connection.execute(_OF_ELEMENTS, {"names": part}))


def _in_order(
    rows: Iterable[_Row], elements: Iterable[str], known: Mapping[int, Published]
) -> Iterator[tuple[str, _Row]]:
    """Yield the elements with their rows: by name, precedence and number."""
    first, *_ = elements
    found: dict[str, dict[tuple[int, int], _Row]] = {element: {} for element in elements}
    for row in rows:
        names = {row.path, row.element} & found.keys() or {first}  # below the path that was asked for
        for name in names:
            found[name][row.version, row.number] = row
    keys = {version: (each.name, each.precedence.key) for version, each in known.items()}
    for element, chosen in found.items():
        mattering = (row for row in chosen.values() if row.version in keys)
        yield from ((element, row) for row in sorted(mattering, key=lambda row: (keys[row.version], row.number)))
