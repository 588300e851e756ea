"""Users of a path, directly and through errors, safety reactions and modes."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from sqlalchemy import Connection, or_, select

from sigcat.limits import REGISTRY_ROWS
from sigcat.registry.published import Published, all_versions, current, lines_by_version
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.tables import USES
from sigcat.registry.use import Use, from_json


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
    versions = all_versions(connection, "function") if is_complete else current(connection)
    known = {each.id: each for each in versions}
    lines = lines_by_version(connection)
    rows = [
        User(known[version], use, through, lines.get(version, ()))
        for version, use, through in _reached(connection, path, known)
    ]
    return Users(tuple(rows[:REGISTRY_ROWS]), max(0, len(rows) - REGISTRY_ROWS))


_Reached = tuple[int, Use, tuple[str, ...]]


def _reached(connection: Connection, path: str, known: Mapping[int, Published]) -> Iterator[_Reached]:
    """Uses breadth first: of the path, then of its consequences, each once."""
    waiting: list[tuple[str, tuple[str, ...]]] = [(path, ())]
    seen, uses = {path}, dict[int, tuple[Use, ...]]()
    told = set[tuple[int, int]]()
    for element, through in waiting:
        for version, number in sorted(_found(connection, element, known), key=lambda key: _order(key, known)):
            if version not in uses:
                uses[version] = from_json(content_of(connection, known[version].uses))
            use = uses[version][number]
            if (version, number) not in told:
                told.add((version, number))
                yield version, use, through
            for name in (use.element, *use.leads_to):
                if name not in seen and (name in use.leads_to or use.path == element):
                    seen.add(name)
                    waiting.append((name, (*through, element) if name in use.leads_to else through))


def _found(connection: Connection, element: str, known: Iterable[int]) -> Iterator[tuple[int, int]]:
    """Versions and numbers of uses; nodes below a branch have paths from `Branch.` on, before `Branch/`."""
    below = (USES.c.path > f"{element}.") & (USES.c.path < f"{element}/")
    chosen = select(USES.c.version_id, USES.c.number).where(
        or_(USES.c.path == element, USES.c.element == element, below)
    )
    versions = frozenset(known)
    return ((version, number) for version, number in connection.execute(chosen) if version in versions)


def _order(key: tuple[int, int], known: Mapping[int, Published]) -> tuple[object, ...]:
    version, number = key
    return known[version].name, known[version].precedence, number
