"""Owners of published functions that a candidate breaks, who must approve it."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeAlias

from sqlalchemy import Connection

from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.compatibility.breaking import broken_by_functions, broken_uses
from sigcat.registry.compatibility.conflicts import Side
from sigcat.registry.compatibility.member import candidate_member
from sigcat.registry.reference import Reference

Affected: TypeAlias = Mapping[str, tuple[str, ...]]
"""Broken functions with their versions, by owner."""


def affected_owners(
    connection: Connection, candidate: Candidate, together: Sequence[Candidate], owner: str
) -> Affected:
    """Return the owners, other than `owner`, whose functions break. `together` are the candidates of one command."""
    functions = [each for each in together if each.kind == "function"]
    sides = (
        _broken_by_function(connection, candidate.name, functions)
        if candidate.kind == "function"
        else _broken_by_nodes(connection, candidate)
    )
    return _by_owner(side for side in sides if side.owner != owner)


def _broken_by_function(connection: Connection, name: str, together: Sequence[Candidate]) -> Iterator[Side]:
    names = {each.name for each in together}
    for conflict in broken_by_functions(connection, [candidate_member(each) for each in together]):
        if conflict.severity == "error" and name in {side.function for side in conflict.sides}:
            yield from (side for side in conflict.sides if side.function not in names)


def _broken_by_nodes(connection: Connection, candidate: Candidate) -> Iterator[Side]:
    if candidate.catalogue is not None:
        for each in broken_uses(connection, candidate.catalogue, candidate.file):
            if each.finding.severity == "error":
                yield each.side


def _by_owner(sides: Iterable[Side]) -> Affected:
    found: dict[str, set[str]] = {}
    for side in sides:
        found.setdefault(side.owner, set()).add(str(Reference(side.function, side.version)))
    return {owner: tuple(sorted(functions)) for owner, functions in sorted(found.items())}
