"""Functions that a change breaks, before anything is published: of a catalogue, or of functions."""

import json
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from sqlalchemy import Connection, select

from sigcat.catalogue.comparing.compatibility import ROWS, Vocabularies
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.findings import Finding
from sigcat.registry.changes import UseChange, relied_changes
from sigcat.registry.compatibility.concerned import concerned
from sigcat.registry.compatibility.conflicts import Conflict, Side, conflicts
from sigcat.registry.compatibility.member import Member, published_member
from sigcat.registry.compatibility.role import RULES, for_role, verb_of
from sigcat.registry.published import Published, current, lines_by_version, published_by_id, running
from sigcat.registry.storing.replay import portions
from sigcat.registry.storing.tables import RELIANCES, USES
from sigcat.registry.use import RELIED_ON, Use, from_row


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
    users = _users(connection, sorted({path for path, _ in changes}))
    known = published_by_id(connection, users)
    lines = lines_by_version(connection, known)
    for version, published in known.items():
        yield from _broken_uses(published, users[version], changes, catalogue, lines.get(version, ()), file)


_Changes = Mapping[tuple[str, str], tuple[UseChange, ...]]
"""Changes by the path of a node and the attributes that a function relies on."""


def _changes(connection: Connection, catalogue: Catalogue) -> _Changes:
    """Changes of attributes that functions rely on. Each attribute is compared once, however many functions rely on it."""
    vocabularies = Vocabularies(catalogue.vocabulary, catalogue.vocabulary)
    nodes, read = catalogue.nodes, lru_cache(maxsize=None)(_read)
    found: dict[tuple[str, str], tuple[UseChange, ...]] = {}
    for path, relied in connection.execute(select(RELIANCES.c.path, RELIANCES.c.relied)):
        old, node = read(relied), nodes.get(path)
        if node is None or old.known != _known(node.values):
            values = None if node is None else node.values
            found[path, relied] = tuple(relied_changes(path, old.values, values, vocabularies))
    return {key: changes for key, changes in found.items() if changes}


class _Relied(NamedTuple):
    """Facts that functions rely on: few texts, which many nodes have."""

    values: Mapping[str, Any]
    known: str


def _read(relied: str) -> _Relied:
    values = json.loads(relied)
    return _Relied(values, _known(values))


def _known(values: Mapping[str, Any]) -> str:
    """The attributes on which functions rely as a text that differs if any of them does, also 1 and true."""
    return repr(list(map(values.get, RELIED_ON)))


def _users(connection: Connection, paths: Sequence[str]) -> Mapping[int, Sequence[Use]]:
    """Uses of the paths by version, in order."""
    found: dict[int, list[Use]] = {}
    chosen = (
        select(USES.c.version_id, USES.c.text, RELIANCES.c.relied)
        .outerjoin(RELIANCES, RELIANCES.c.id == USES.c.reliance_id).order_by(USES.c.version_id, USES.c.number)
    )  # fmt: skip
    for part in portions(paths):
        for version, text, relied in connection.execute(chosen.where(USES.c.path.in_(part))):
            found.setdefault(version, []).append(from_row(text, relied))
    return found


def _broken_uses(
    published: Published,
    uses: Sequence[Use],
    changes: _Changes,
    catalogue: Catalogue,
    lines: Sequence[str],
    file: str,
) -> Iterator[BrokenUse]:
    calls = _calls(uses)
    strictest = sorted(uses, key=lambda use: not use.is_optional)  # of several uses in one role, the last one counts
    for (path, _), use in {(use.path, use.provides): use for use in strictest}.items():
        for change in for_role(use, changes.get((path, use.relied), ())):
            side = Side(published.name, published.version, published.owner, calls[path])
            yield BrokenUse(side, _finding(change, side, lines, _place(change, catalogue, file), use.via))


def _calls(uses: Sequence[Use]) -> Mapping[str, tuple[str, ...]]:
    found: dict[str, dict[str, None]] = {}
    for use in uses:
        found.setdefault(use.path, {}).update({use.call: None} if use.call else {})
    return {path: tuple(calls) for path, calls in found.items()}


def _finding(change: UseChange, side: Side, lines: Sequence[str], place: tuple[str, int, int], via: str) -> Finding:
    through = f", through {via}" if via else ""
    where = f", in line {', '.join(lines)}" if lines else ""
    message = f"{change.sentence} {verb_of(change)} {side.sentence}{through}{where}."
    why = ROWS[change.rule].why
    return RULES[change.compatibility].finding(message, *place, path=change.element, fix=why)


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
    fields = _fields(connection, names)
    own = {each.id: each for versions in fields.values() for each in versions if each.name in names}
    known = {number: published_member(connection, each) for number, each in own.items()}
    rest = {each.id: each for versions in fields.values() for each in versions if each.name not in names}
    for each in concerned(connection, deployed, list(known.values()), list(rest.values())):
        known[each.id] = published_member(connection, each)
    found: dict[Conflict, list[str]] = {}
    for line, versions in fields.items():
        members = [known[each.id] for each in versions if each.id in known]
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
