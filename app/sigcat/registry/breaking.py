"""Functions that a change breaks, before anything is published: of a catalogue, or of functions."""

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sqlalchemy import Connection, select

from sigcat import codes
from sigcat.catalogue.comparing.changes import Class
from sigcat.catalogue.comparing.compatibility import ROWS, Vocabularies
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.findings import Finding
from sigcat.registry.changes import UseChange, relied_changes
from sigcat.registry.conflicts import Conflict, Side, conflicts
from sigcat.registry.member import Member, published_member
from sigcat.registry.published import Published, current, lines_by_version, running
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.tables import USES
from sigcat.registry.use import Use, from_json

_ABOUT = {"breaking": codes.BREAKS_A_PUBLISHED_FUNCTION, "risky": codes.MAY_BREAK_A_PUBLISHED_FUNCTION}


class BrokenUse(NamedTuple):
    """A published function that a change of a catalogue breaks, or may break."""

    side: Side
    finding: Finding


def broken_by_catalogue(connection: Connection, catalogue: Catalogue, file: str) -> tuple[Finding, ...]:
    """Findings about published functions that rely on what a catalogue no longer has, or has otherwise."""
    return tuple(dict.fromkeys(each.finding for each in broken_uses(connection, catalogue, file)))


def broken_uses(connection: Connection, catalogue: Catalogue, file: str) -> Iterator[BrokenUse]:
    """Yield the published functions that a catalogue breaks, with the finding about each use."""
    changes = _changes(connection, catalogue)
    users = _users(connection, {path for path, _ in changes})
    lines = lines_by_version(connection)
    for published in current(connection):
        if published.id in users:
            yield from _broken_uses(connection, published, changes, catalogue, lines.get(published.id, ()), file)


_Changes = Mapping[tuple[str, str], tuple[UseChange, ...]]
"""Changes by the path of a node and the attributes that a function relies on."""


def _changes(connection: Connection, catalogue: Catalogue) -> _Changes:
    """Changes of what functions rely on, which is compared once, however many they are."""
    vocabularies = Vocabularies(catalogue.vocabulary, catalogue.vocabulary)
    found: dict[tuple[str, str], tuple[UseChange, ...]] = {}
    for path, relied in connection.execute(select(USES.c.path, USES.c.relied).distinct()):
        node = catalogue.get(path)
        if relied:
            changes = relied_changes(path, json.loads(relied), None if node is None else node.values, vocabularies)
            found[path, relied] = tuple(changes)
    return {key: changes for key, changes in found.items() if changes}


def _users(connection: Connection, paths: Iterable[str]) -> frozenset[int]:
    """Versions that use one of the paths."""
    chosen = (select(USES.c.version_id).where(USES.c.path == path) for path in paths)
    return frozenset(version for each in chosen for version in connection.execute(each).scalars())


def _broken_uses(
    connection: Connection,
    published: Published,
    changes: _Changes,
    catalogue: Catalogue,
    lines: Sequence[str],
    file: str,
) -> Iterator[BrokenUse]:
    uses = from_json(content_of(connection, published.uses))
    calls = _calls(uses)
    for path, use in {use.path: use for use in uses}.items():
        for change in _for_role(use, changes.get((path, use.relied), ())):
            side = Side(published.name, published.version, published.owner, calls[path])
            yield BrokenUse(side, _finding(change, side, lines, _place(change, catalogue, file), use.via))


_OF_PROVIDERS: Mapping[str, Class] = {
    **dict.fromkeys(("range-narrowed", "values-limited", "values-removed"), "breaking"),
    **dict.fromkeys(("range-widened", "values-unlimited", "values-added"), "compatible"),
}
"""Classes for a function that provides a value, by rule: it may send what is no longer allowed, whatever the node is."""


def _for_role(use: Use, changes: Iterable[UseChange]) -> Iterator[UseChange]:
    """Yield the changes that break a use, or may."""
    for change in changes:
        compatibility = _OF_PROVIDERS.get(change.rule) if use.provides else None
        found = change if compatibility is None else change._replace(compatibility=compatibility)
        if found.compatibility in _ABOUT:
            yield found


def _calls(uses: Sequence[Use]) -> Mapping[str, tuple[str, ...]]:
    found: dict[str, dict[str, None]] = {}
    for use in uses:
        found.setdefault(use.path, {}).update({use.call: None} if use.call else {})
    return {path: tuple(calls) for path, calls in found.items()}


def _finding(change: UseChange, side: Side, lines: Sequence[str], place: tuple[str, int, int], via: str) -> Finding:
    verb = "breaks" if change.compatibility == "breaking" else "may break"
    through = f", through {via}" if via else ""
    where = f", in line {', '.join(lines)}" if lines else ""
    message = f"{change.sentence} {verb} {side.sentence}{through}{where}."
    why = ROWS[change.rule].why
    return _ABOUT[change.compatibility].finding(message, *place, path=change.element, fix=why)


def _place(change: UseChange, catalogue: Catalogue, file: str) -> tuple[str, int, int]:
    """The line of a change in a file of the catalogue; for a node that is gone, the statement that deletes it."""
    node = catalogue.get(change.element)
    if node is not None:
        definition = node.definition
        origin = definition.origin(change.attribute) if change.attribute in definition.values else definition.origin()
        return origin.position
    for layer in catalogue.layers:
        for statement in layer.statements:
            is_above = change.element == statement.path or change.element.startswith(f"{statement.path}.")
            if is_above and statement.values.get("delete") is True:
                return statement.origin("delete").position
    return file, 0, 0


def broken_by_functions(connection: Connection, deployed: Sequence[Member]) -> tuple[Conflict, ...]:
    """Conflicts that functions bring to the vehicle lines in which they run, and to the newest published functions."""
    names = {each.name for each in deployed}
    known = {each.id: published_member(connection, each) for each in current(connection)}
    found: dict[Conflict, list[str]] = {}
    for line, versions in _fields(connection, names).items():
        members = [known[each.id] for each in versions]
        others = [each for each in members if each.name not in names]
        replaced = [each for each in members if each.name in names]
        for conflict in conflicts(deployed, others, replaced):
            found.setdefault(conflict, []).extend([line] if line else [])
    return tuple(conflict._replace(lines=tuple(lines)) for conflict, lines in found.items())


def _fields(connection: Connection, names: set[str]) -> Mapping[str, Sequence[Published]]:
    """Versions by the lines in which one of the functions runs; without a line, the newest ones."""
    fields: dict[str, list[Published]] = {}
    for each in running(connection):
        fields.setdefault(each.line, []).append(each.published)
    newest = {each.name: each for each in current(connection)}
    concerned = {line: found for line, found in fields.items() if names & {each.name for each in found}}
    return {**concerned, "": tuple(newest.values())}
