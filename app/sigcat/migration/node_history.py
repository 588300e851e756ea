"""History of a node over releases: where it was added, what changed, where it moved, where it was removed.

Each pair of neighbouring releases is compared as `sigcat diff` and `sigcat migrate` compare them, with the shipped tables of moves.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Literal, NamedTuple

from sigcat.catalogue.comparing.changes import AttributeChange, same
from sigcat.catalogue.comparing.compatibility import Vocabularies, attribute_change, attribute_changes
from sigcat.catalogue.comparing.diff import SAID_BY_A_MOVE
from sigcat.catalogue.comparing.instance_changes import instances_as_written
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.data import ROOT_FILE
from sigcat.migration.migration import Fate, Migration
from sigcat.migration.table import release_of, shipped_tables, tables_between

EventKind = Literal["oldest", "added", "moved", "changed", "removed"]
_UNCHANGED = Fate("same", "")


class Release(NamedTuple):
    """An official release that is here, or a catalogue that is made of one."""

    number: str
    """Such as `5.1`."""
    catalogue: Catalogue
    is_own: bool = False
    """Whether it is a catalogue that is made of the release."""

    @property
    def name(self) -> str:
        """Name in events: empty for a catalogue that is made of a release."""
        return "" if self.is_own else self.number


class Event(NamedTuple):
    """A fact about a node in one release, compared with the release before it."""

    release: str
    """Number of the release; empty: the catalogue itself."""
    kind: EventKind
    """`oldest`: the oldest release here has the node already."""
    path: str
    """Path in this release; empty if it was removed."""
    former: str = ""
    """Path before, if it is another one."""
    attributes: tuple[AttributeChange, ...] = ()
    is_certain: bool = True
    """Whether the former node is known to be this one."""
    note: str = ""
    """Why it moved or was removed, if a table or a deprecation says so."""
    skipped: tuple[str, ...] = ()
    """Releases between this one and the one before that are not here: it may have happened in one of them."""


def instance_of(path: str, instances: Sequence[Node]) -> str:
    """Return the path of the first of the innermost instances of a definition; the path itself without instances."""
    return max((each.path for each in instances), key=lambda each: each.count("."), default=path)


class NodeHistory(NamedTuple):
    """The events of a node, oldest first."""

    path: str
    release: str
    """The release that the catalogue is, or is made of; empty if it does not say so."""
    events: tuple[Event, ...]
    releases: tuple[str, ...]
    """The releases that were compared, oldest first."""
    missing: tuple[str, ...]
    """Known releases that are not here."""


def official_releases(catalogues: Iterable[tuple[Source, Catalogue]]) -> tuple[Release, ...]:
    """Return the official releases among catalogues, oldest first. A pulled one counts before the shipped tree."""
    found: dict[str, Release] = {}
    for source, catalogue in sorted(catalogues, key=lambda each: not each[0].release):
        if _is_official(source) and (name := release_of(catalogue) or source.release.removeprefix("v")):
            found.setdefault(name, Release(name, catalogue))
    return tuple(sorted(found.values(), key=lambda each: _numbers(each.number)))


def node_history(path: str, catalogue: Catalogue, releases: Sequence[Release]) -> NodeHistory:
    """The history of a node of a catalogue with its instances expanded, which is a release or is made of one."""
    own = release_of(catalogue)
    chain = _with_own(own, catalogue, releases)
    events = tuple(_events(path, Release(own, catalogue, is_own=True), chain)) if own else ()
    names = tuple(each.number for each in releases)
    known = dict.fromkeys([shipped_tables()[0].old, *(table.new for table in shipped_tables())])
    newest = max((_numbers(name) for name in (own, *names) if name), default=[])
    missing = tuple(name for name in known if name not in names and _numbers(name) <= newest)
    return NodeHistory(path, own, events, names, missing)


def _with_own(own: str, catalogue: Catalogue, releases: Sequence[Release]) -> tuple[Release, ...]:
    """The releases; without the one that a catalogue is made of, the catalogue has its place."""
    if own in [each.number for each in releases]:
        return tuple(releases)
    return tuple(sorted((*releases, Release(own, catalogue, is_own=True)), key=lambda each: _numbers(each.number)))


def _is_official(source: Source) -> bool:
    is_final = "-" not in source.release
    return not source.overlays and is_final and (bool(source.release) or source.spec == ROOT_FILE)


def _numbers(name: str) -> list[int]:
    return [int(number) for number in re.findall("[0-9]+", name)]


# -- events -------------------------------------------------------------------------------------------------------


def _events(path: str, own: Release, chain: Sequence[Release]) -> Iterator[Event]:
    """Yield the events of all releases, and after those of its own release that of the catalogue itself."""
    position = [each.number for each in chain].index(own.number)
    base = chain[position]
    if base.catalogue is own.catalogue:
        yield from _before(path, chain[: position + 1])
        yield from _after(path, chain[position:])
        return
    pair = pair_of(base, own)
    former = pair.former(path)
    if former is None:
        yield Event("", "added", path)
        return
    yield from _before(former[0], chain[: position + 1])
    yield from pair.event(*former, path, "")
    yield from _after(former[0], chain[position:])


def _before(path: str, chain: Sequence[Release]) -> Iterator[Event]:
    """Yield the events up to the last release of a chain, oldest first."""
    if len(chain) == 1:
        yield Event(chain[0].name, "oldest", path)
        return
    older, newer = chain[-2:]
    pair = pair_of(older, newer)
    former = pair.former(path)
    if former is None:
        yield Event(newer.name, "added", path, skipped=_between(older, newer))
        return
    yield from _before(former[0], chain[:-1])
    yield from pair.event(*former, path, newer.name, _between(older, newer))


def _after(path: str, chain: Sequence[Release]) -> Iterator[Event]:
    """Yield the events after the first release of a chain, until the node is removed."""
    for older, newer in pairwise(chain):
        pair = pair_of(older, newer)
        fate = pair.fate(path)
        if not fate.path or fate.path not in newer.catalogue.nodes:
            yield Event(newer.name, "removed", "", path, note=_note(fate), skipped=_between(older, newer))
            return
        yield from pair.event(path, fate, fate.path, newer.name, _between(older, newer))
        path = fate.path


def _note(fate: Fate) -> str:
    """Return why a node was removed, and the nodes that may have replaced it."""
    choices = f"Possible successors: {', '.join(fate.choices)}." if fate.choices else ""
    return " ".join(filter(None, (fate.why, choices)))


def _between(older: Release, newer: Release) -> tuple[str, ...]:
    tables = tables_between(older.number, newer.number)
    return tuple(table.new for table in tables[:-1])


# -- two neighbouring releases ------------------------------------------------------------------------------------


class Pair:
    """Two neighbouring releases. Frozen; both trees are compared only for a node that one of them does not have."""

    def __init__(self, old: Release, new: Release) -> None:
        self._old = old.catalogue
        self._new = new.catalogue
        self._migration = Migration(self._old, self._new, tables_between(old.number, new.number))
        self._vocabularies = Vocabularies(self._old.vocabulary, self._new.vocabulary)

    def fate(self, path: str) -> Fate:
        """Return what becomes of a node of the older release."""
        return self._migration.fate(path, is_signal=True)

    def former(self, path: str) -> tuple[str, Fate] | None:
        """Return the path of a node of the newer release in the older one, and what became of that; None if it is new."""
        if path in self._old.nodes and self.fate(path).status == "same":
            return path, _UNCHANGED
        return self._arrivals.get(path)

    def event(self, former: str, fate: Fate, path: str, release: str, skipped: tuple[str, ...] = ()) -> Iterator[Event]:
        """Yield the event of a node that both releases have, if anything differs."""
        attributes = self._changes(self._old.nodes[former], self._new.nodes[path])
        if former != path:
            others = tuple(each for each in attributes if each.name not in SAID_BY_A_MOVE)
            yield Event(release, "moved", path, former, others, fate.is_certain, fate.why, skipped)
        elif attributes:
            yield Event(release, "changed", path, "", attributes, skipped=skipped)

    def _changes(self, before: Node, after: Node) -> tuple[AttributeChange, ...]:
        changes = attribute_changes(before.values, after.values, self._vocabularies)
        return (*_instances(before, after), *changes)

    @cached_property
    def _arrivals(self) -> Mapping[str, tuple[str, Fate]]:
        """Former paths of nodes that moved, by their new path. What is certain counts before guesses and choices."""
        gone = [(path, self.fate(path)) for path in self._old.nodes]
        moved = [(path, fate) for path, fate in gone if fate.status != "same"]
        found: dict[str, tuple[str, Fate]] = {}
        for path, fate in sorted(moved, key=lambda each: not each[1].is_certain):
            for target in (fate.path,) if fate.path else fate.choices:
                found.setdefault(target, (path, fate))
        return found


@lru_cache(maxsize=32)
def pair_of(old: Release, new: Release) -> Pair:
    """Two releases, compared once."""
    return Pair(old, new)


def _instances(before: Node, after: Node) -> Iterator[AttributeChange]:
    """Yield the change of the instances of a branch."""
    old, new = instances_as_written(before), instances_as_written(after)
    if same(old, new):
        return
    names, names_now = ({child.name for child in node.children} for node in (before, after))
    rule = "removed" if names - names_now else "added" if names_now - names else "respelled"
    yield attribute_change("instances", old, new, f"instances-{rule}")


# -- text ---------------------------------------------------------------------------------------------------------


def history_summary(history: NodeHistory) -> str:
    """The history in one line: `since 3.1; moved in 4.0 from Vehicle.X; unit changed in 5.1`."""
    return "; ".join(event_text(event, history) for event in history.events)


def event_text(event: Event, history: NodeHistory) -> str:
    """An event as a phrase, seen from the catalogue in which the history was asked for."""
    where = release_text(event)
    changed = ", ".join(change.name for change in event.attributes)
    if event.kind == "moved":
        moved = "moved" if event.is_certain else "probably moved"
        is_later = bool(event.release) and _numbers(event.release) > _numbers(history.release)
        other = f"to {event.path}" if is_later else f"from {event.former}"
        return f"{moved} in {where} {other}" + (f" ({changed} changed)" if changed else "")
    phrases = {"oldest": "in {} already", "added": "since {}", "removed": "removed in {}"}
    return phrases.get(event.kind, f"{changed} changed in {{}}").format(where)


def release_text(event: Event) -> str:
    """The release of an event, with those between that are not here: `5.1 or 6.0`."""
    return " or ".join((*event.skipped, event.release or "this catalogue"))
