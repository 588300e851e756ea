"""Functions that a change breaks, before anything is published: of a catalogue, or of functions."""

from collections.abc import Iterator, Mapping, Sequence

from sqlalchemy import Connection

from sigcat import codes
from sigcat.catalogue.comparing.compatibility import ROWS, Vocabularies
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.findings import Finding
from sigcat.registry.changes import UseChange, relied_changes
from sigcat.registry.conflicts import Conflict, Side, conflicts
from sigcat.registry.member import Member, published_member
from sigcat.registry.published import Published, content_of, current, lines_by_version, running
from sigcat.registry.use import Use, from_json

_ABOUT = {"breaking": codes.BREAKS_A_PUBLISHED_FUNCTION, "risky": codes.MAY_BREAK_A_PUBLISHED_FUNCTION}


def broken_by_catalogue(connection: Connection, catalogue: Catalogue, file: str) -> tuple[Finding, ...]:
    """Findings about published functions that rely on what a catalogue no longer has, or has otherwise."""
    lines = lines_by_version(connection)
    found = (
        finding
        for published in current(connection)
        for finding in _broken_uses(connection, published, catalogue, lines.get(published.id, ()), file)
    )
    return tuple(dict.fromkeys(found))


def _broken_uses(
    connection: Connection, published: Published, catalogue: Catalogue, lines: Sequence[str], file: str
) -> Iterator[Finding]:
    uses = [use for use in from_json(content_of(connection, published.uses)) if use.is_in_catalogue and use.path]
    calls = _calls(uses)
    vocabularies = Vocabularies(catalogue.vocabulary, catalogue.vocabulary)
    for path, use in {use.path: use for use in uses}.items():
        node = catalogue.get(path)
        for change in relied_changes(path, use.values, None if node is None else node.values, vocabularies):
            if change.compatibility in _ABOUT:
                side = Side(published.name, published.version, published.owner, calls[path])
                yield _finding(change, side, lines, _place(change, catalogue, file), use.via)


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
