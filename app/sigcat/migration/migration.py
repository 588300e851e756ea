"""A migration: what becomes of each path, and of the values at it, between two catalogues."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from typing import Any, Literal, NamedTuple

from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.compatibility import Vocabularies
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.function.function_json.conversion import IDENTITY, Linear, between
from sigcat.migration.labelled_path import LabelledPath, bracketed, labelled, parsed, plain, template
from sigcat.migration.table import CERTAIN, Entry, Step, Table, applied, value_names
from sigcat.names import nearest, parent_path

Status = Literal["same", "moved", "guess", "choice", "gone"]
_GUESSED = 0.5
"""Confidence of a move that only the equal definition shows."""
_MOST_CHOICES = 6


class Fate(NamedTuple):
    """The new state of a path. `path` is the new one, also where it is only a guess."""

    status: Status
    path: str
    confidence: float = CERTAIN
    why: str = ""
    choices: tuple[str, ...] = ()

    @property
    def is_certain(self) -> bool:
        """Whether the new path is known."""
        return self.status in ("same", "moved")


class UnitChange(NamedTuple):
    """The units of a signal on both sides; `conversion` is None if none exists."""

    old: str
    new: str
    conversion: Linear | None


class Migration:
    """Paths and values of an old catalogue in a new one. Frozen."""

    def __init__(
        self,
        old: Catalogue,
        new: Catalogue,
        tables: tuple[Table, ...] = (),
        choices: Mapping[str, str] | None = None,
        *,
        accepts_guesses: bool = False,
    ) -> None:
        self.old = old
        self.new = new
        self.accepts_guesses = accepts_guesses
        self._tables = tables
        self._choices = choices or {}
        self._fates: dict[tuple[str, bool], Fate] = {}
        self._vocabularies = Vocabularies(old.vocabulary, new.vocabulary)

    # -- paths

    def knows(self, text: str) -> bool:
        """Whether a text is the path of a node of the old catalogue, or of one that a person moved."""
        return text in self.old.nodes or text in self.old.definitions or text in self._choices

    def fate(self, path: str, *, is_signal: bool = False) -> Fate:
        """Return what becomes of a path. A signal must be a node with its instances expanded."""
        key = (path, is_signal)
        if key not in self._fates:
            found = self._fate(path, is_signal=is_signal)
            accepted = found.status == "guess" and self.accepts_guesses
            self._fates[key] = found._replace(status="moved") if accepted else found
        return self._fates[key]

    def _fate(self, path: str, *, is_signal: bool) -> Fate:
        chosen = self._chosen(path)
        if chosen is not None:
            return Fate("moved" if chosen != path else "same", chosen)
        known, rest = labelled(path, self.old)
        if not known or (rest and self._is_newer(path, known)):
            return Fate("same", path)
        if rest:
            above = self.fate(plain(known))
            return above._replace(
                path=f"{above.path}.{rest}", choices=tuple(f"{choice}.{rest}" for choice in above.choices)
            )
        if self._has(path, is_signal=is_signal) and self._is_alike(path, template(known), path):
            return Fate("same", path)
        return self._fate_of_known(path, known, is_signal=is_signal)

    def _chosen(self, path: str) -> str | None:
        """Return what a person chose for a path, or for one above it."""
        above = path
        while above:
            if above in self._choices:
                return self._choices[above] + path[len(above) :]
            above = parent_path(above)
        return None

    def _is_newer(self, path: str, known: LabelledPath) -> bool:
        """Whether the new catalogue knows more of a path than the old one: it was migrated before."""
        return len(plain(labelled(path, self.new)[0])) > len(plain(known))

    def _has(self, path: str, *, is_signal: bool) -> bool:
        return (
            path in self.new.nodes
            if is_signal and path in self.old.nodes
            else self._definition_in_new(path) is not None
        )

    def has_definition(self, path: str) -> bool:
        """Whether the new catalogue has a node."""
        return self._definition_in_new(path) is not None

    def _definition_in_new(self, path: str) -> Definition | None:
        node = self.new.get(path)
        return node.definition if node is not None else self.new.definitions.get(path)

    def _is_alike(self, path: str, old_template: str, target: str) -> bool:
        """Whether both are signals, or both branches."""
        old = self.old.get(path)
        before = old.definition if old is not None else self.old.definitions.get(old_template)
        after = self._definition_in_new(target)
        return before is None or after is None or ("datatype" in before.values) is ("datatype" in after.values)

    def _fate_of_known(self, path: str, known: LabelledPath, *, is_signal: bool) -> Fate:
        step = _through(known, self._tables)
        target = plain(step.path) if step.path is not None else ""
        choices = tuple(p for each in step.choices for p in self._instances(each, path, is_signal=is_signal))
        if target and target != path and self._has_target(target, path, known, is_signal=is_signal):
            status: Status = "moved" if step.confidence == CERTAIN else "guess"
            return Fate(status, target, step.confidence, step.why, choices)
        return self._computed(path) if not step.why and not choices else _undecided(step, choices)

    def _has_target(self, target: str, path: str, known: LabelledPath, *, is_signal: bool) -> bool:
        is_there = target in self.new.nodes if is_signal else self.has_definition(target)
        return is_there and self._is_alike(path, template(known), target)

    def _instances(self, choice: str, path: str, *, is_signal: bool) -> Iterator[str]:
        """Yield a possible target; for a signal, each of its instances."""
        parts = parsed(choice)
        target = plain(parts) if parts is not None else choice
        if target == path:
            return
        if not is_signal or target in self.new.nodes:
            yield from (target,) if self.has_definition(target) else ()
        else:
            yield from (node.path for node in self.new.nodes.values() if node.template == target)

    def _computed(self, path: str) -> Fate:
        """Return what a comparison of both trees shows."""
        move = self._moves.get(path)
        if move is not None:
            target, is_guess = move
            return Fate("guess" if is_guess else "moved", target, _GUESSED if is_guess else CERTAIN, "", (target,))
        node = self.old.get(path)
        instances = [each.path for each in self.new.nodes.values() if each.template == path and each.path != path]
        if instances:
            return Fate("choice", "", 0, "It has instances now.", tuple(instances))
        note = node.values.get("deprecation", "") if node is not None else ""
        why = f"Its deprecation note says: {note}." if isinstance(note, str) and note else ""
        return Fate("gone", "", 0, why.replace("..", "."), ())

    @cached_property
    def _moves(self) -> Mapping[str, tuple[str, bool]]:
        found: dict[str, tuple[str, bool]] = {}
        for change in compare(self.old, self.new):
            for former, path in _moved_paths(change):
                found[former] = (path, change.is_guess)
                for node in self.old.nodes[former].walk():
                    found.setdefault(node.path, (path + node.path[len(former) :], change.is_guess))
        return {former: move for former, move in found.items() if move[0] in self.new.nodes}

    def proposals(self, path: str) -> tuple[str, ...]:
        """Paths of the new catalogue that resemble a removed one."""
        return nearest(path, (each for each, node in self.new.definitions.items() if "datatype" in node.values))

    # -- values

    def definitions(self, path: str, target: str) -> tuple[Mapping[str, Any], Mapping[str, Any]] | None:
        """Return the attributes of a node in both catalogues; None if one of them does not have it."""
        old, new = self.old.get(path), self.new.get(target)
        before = old.definition if old is not None else self.old.definitions.get(path)
        after = new.definition if new is not None else self.new.definitions.get(target)
        return (before.values, after.values) if before is not None and after is not None else None

    def value_names(self, path: str, target: str) -> Mapping[str, str]:
        """Return the new names of values of a signal, by old name: of the same numbers, or by the tables."""
        both = self.definitions(path, target)
        if both is None:
            return {}
        old, new = (values.get("enum") for values in both)
        if isinstance(old, Mapping) and isinstance(new, Mapping):
            added = {number: name for name, number in new.items() if name not in old}
            return {name: added[number] for name, number in old.items() if name not in new and number in added}
        allowed = both[1].get("allowed") or ()
        names = value_names(labelled(path, self.old)[0], self._tables)
        return {name: to for name, to in names.items() if to in allowed and name not in allowed}

    def removed_values(self, path: str, target: str) -> frozenset[str]:
        """Return the names of values of a signal that the new catalogue has no more."""
        old, new = self.definitions(path, target) or ({}, {})
        before, after = (frozenset(filter(_is_text, v.get("enum") or v.get("allowed") or ())) for v in (old, new))
        return before - after - self.value_names(path, target).keys() if after else frozenset()

    def unit_change(self, old: Any, new: Any) -> UnitChange:
        """Return how values change from one unit to another; units that are not texts count as absent."""
        before, after = (unit if isinstance(unit, str) else "" for unit in (old, new))
        if before == after or (before and after and self._vocabularies.are_one_unit(before, after)):
            return UnitChange(before, after, IDENTITY)
        if not before or not after:
            return UnitChange(before, after, None)
        keys = [known.key if known else key for known, key in self._known_units(before, after)]
        return UnitChange(before, after, between(keys[0], keys[1]))

    def _known_units(self, before: str, after: str) -> tuple[tuple[Any, str], tuple[Any, str]]:
        return (self.old.vocabulary.unit(before), before), (self.new.vocabulary.unit(after), after)

    def unit_in_new(self, unit: str) -> str:
        """Return the key of a unit in the new catalogue; empty if it has none."""
        found = self.new.vocabulary.unit(unit)
        if found is not None:
            return unit if unit in (found.key, found.name) else found.key
        before = self.old.vocabulary.unit(unit)
        same = (u.key for u in self.new.vocabulary.distinct_units if before is not None and u.name == before.name)
        return next(same, "")


def _through(path: LabelledPath, tables: Iterable[Table]) -> Step:
    """Return what several tables say about a path, one after the other."""
    waiting = list(tables)
    step = Step(path)
    while waiting:
        table = waiting.pop(0)
        assert step.path is not None
        following = applied(step.path, table)
        step = Step(
            following.path,
            step.confidence * following.confidence if following.path is not None else following.confidence,
            " ".join(filter(None, (step.why, following.why))),
            following.choices,
        )
        if step.path is None:
            choices = [_through(parts, waiting) for each in step.choices if (parts := parsed(each)) is not None]
            return step._replace(choices=tuple(bracketed(each.path) for each in choices if each.path is not None))
    return step


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


def _undecided(step: Step, choices: tuple[str, ...]) -> Fate:
    if choices:
        return Fate("choice", "", 0, step.why, choices[:_MOST_CHOICES])
    return Fate("gone", "", 0, step.why)


def _moved_paths(change: Change) -> Iterator[tuple[str, str]]:
    return zip(change.former_paths, change.paths, strict=False) if change.kind == "moved" else iter(())


def table_of(changes: Iterable[Change], old: str, new: str) -> Table:
    """Return the moves that a comparison shows as a table; guesses have a confidence."""
    moves: dict[str, Entry] = {}
    for change in changes:
        if change.kind == "moved":
            confidence = _GUESSED if change.is_guess else CERTAIN
            why = "Its definition is the same." if change.is_guess else ""
            moves[change.former] = Entry((change.path,), confidence, why)
        elif change.kind == "removed":
            moves[change.path] = Entry((), 0, change.note)
    return Table(old, new, moves, {})
