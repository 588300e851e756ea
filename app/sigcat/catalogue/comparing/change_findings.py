"""Changes as findings at the lines that changed, for annotations of a pull request."""

import os
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path

from sigcat.catalogue.comparing.bindings import reason
from sigcat.catalogue.comparing.changes import CLASSES, Change, Class
from sigcat.catalogue.comparing.diff_report import sentence
from sigcat.catalogue.comparing.sides import Side
from sigcat.catalogue.reading.statement import Origin
from sigcat.findings import Finding, Severity

_SEVERITIES: Mapping[Class, Severity] = {"breaking": "error", "risky": "warning", "compatible": "info", "text": "info"}
_NOWHERE = Origin("", 0, 0)


def change_findings(changes: Sequence[Change], old: Side, new: Side) -> tuple[Finding, ...]:
    """Return a finding for each change, the worst first: build servers show the first ones only.

    What is gone is reported at the statement that deletes it, else at the last one before it that is still there.
    """
    places = _Places(old, new)
    ordered = sorted(changes, key=lambda change: CLASSES.index(change.compatibility))
    return tuple(_finding(change, places.of(change)) for change in ordered)


def _finding(change: Change, place: Origin) -> Finding:
    is_said = {change.compatibility} == {attribute.compatibility for attribute in change.attributes}
    message = f"{sentence(change)}." if is_said else f"{sentence(change)} ({change.compatibility})."
    why = reason(change.rule)
    return Finding(
        change.rule, _SEVERITIES[change.compatibility], message, *place.position, path=change.paths[0], fix=why
    )


class _Places:
    """The lines of the new side, by what changed there."""

    def __init__(self, old: Side, new: Side) -> None:
        self._old = old
        self._new = new

    def of(self, change: Change) -> Origin:
        """Return where a change was written; nowhere if that is not below the current folder, as in a release."""
        if change.kind == "removed":
            deleting = self._deleting.get(change.path)
            return self._before(change.paths[0]) if deleting is None else _as_here(deleting, self._new)
        definition = self._new.catalogue.nodes[change.paths[0]].definition
        names = [attribute.name for attribute in change.attributes if attribute.name in definition.values]
        if names:
            return _as_here(definition.origin(names[0]), self._new)
        statements = definition.statements
        if not statements:
            return _NOWHERE
        return _as_here(statements[0 if change.kind == "added" else -1].origin(), self._new)

    @cached_property
    def _deleting(self) -> Mapping[str, Origin]:
        statements = (statement for layer in self._new.catalogue.layers for statement in layer.statements)
        return {each.path: each.origin("delete") for each in statements if each.values.get("delete") is True}

    def _before(self, path: str) -> Origin:
        """Return the place of the last statement before a node that is gone which is still in its file."""
        gone = _as_here(self._old.catalogue.nodes[path].definition.origin(), self._old)
        kept = [(line, place) for line, place in self._kept.get(gone.file, ()) if line < gone.line]
        if kept:
            return max(kept)[1]
        return Origin(gone.file, 1, 1) if gone.file in self._files else _NOWHERE

    @cached_property
    def _files(self) -> frozenset[str]:
        return frozenset(_as_here(Origin(file.name, 0, 0), self._new).file for file in self._new.catalogue.files)

    @cached_property
    def _kept(self) -> Mapping[str, Sequence[tuple[int, Origin]]]:
        """By file, the lines of statements in the old side, each with its place in the new one."""
        now = dict(_statements(self._new))
        kept: dict[str, list[tuple[int, Origin]]] = defaultdict(list)
        for key, place in _statements(self._old):
            if key in now:
                kept[place.file].append((place.line, now[key]))
        return kept


def _statements(side: Side) -> Iterator[tuple[tuple[str, str], Origin]]:
    for layer in side.catalogue.layers:
        for statement in layer.statements:
            place = _as_here(statement.origin(), side)
            if place.file:
                yield (place.file, statement.path), place


def _as_here(place: Origin, side: Side) -> Origin:
    """Name the file as it is seen from the current folder; nowhere if it is not below it."""
    start = Path(side.folder or Path.cwd())
    file = os.path.relpath(start / place.file, start)
    return _NOWHERE if file.startswith("..") else place._replace(file=file)
