"""Changes of one file: replaced parts with their lines, and findings."""

import difflib
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from yaml.nodes import Node, ScalarNode

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.importing.yaml_edits import Edit, Text, edited
from sigcat.function.importing.yaml_text import scalar
from sigcat.migration.migration import Fate, Migration
from sigcat.text_lines import lines_of


class Replacement(NamedTuple):
    """A part of a text, what takes its place, and the line of the report."""

    edit: Edit
    line: int
    note: str


Outcome = Replacement | Finding


class Migrated(NamedTuple):
    """A file before and after the migration."""

    file: str
    before: bytes
    after: bytes
    changes: tuple[tuple[int, str], ...] = ()
    """Line and note of each change."""
    findings: tuple[Finding, ...] = ()
    values: tuple[str, ...] = ()
    """New paths of the signals whose values were converted, where the file does not state their units."""

    @property
    def is_changed(self) -> bool:
        """Whether the text differs."""
        return self.before != self.after

    @property
    def diff(self) -> str:
        """The change as a unified diff."""
        before, after = (lines_of(text.decode("utf-8", "replace"), keepends=True) for text in (self.before, self.after))
        lines = difflib.unified_diff(before, after, self.file, self.file)
        return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


_BOM = "\ufeff"


def migrated(file: str, data: bytes, outcomes: Iterable[Outcome]) -> Migrated:
    """Apply replacements to a file in UTF-8; its byte order mark stays."""
    known = tuple(dict.fromkeys(outcomes))
    replacements = list(_disjoint(each for each in known if isinstance(each, Replacement)))
    text = data.decode("utf-8")
    mark = _BOM if text.startswith(_BOM) else ""
    after = mark + edited(text.removeprefix(_BOM), (each.edit for each in replacements))
    changes = tuple(sorted({(each.line, each.note) for each in replacements}))
    return Migrated(file, data, after.encode(), changes, tuple(each for each in known if isinstance(each, Finding)))


def _disjoint(replacements: Iterable[Replacement]) -> Iterator[Replacement]:
    """Yield replacements in the order of the text; of two for one value, the first one counts."""
    end = 0
    for each in sorted(replacements, key=lambda one: (one.edit.start, one.edit.end)):
        if each.edit.start >= end:
            yield each
            end = max(end, each.edit.end)


# -- YAML ---------------------------------------------------------------------------------------------------------


def line_of(node: Node) -> int:
    """Line of a node, from 1."""
    return int(node.start_mark.line) + 1


def end_of(text: str, node: Node) -> int:
    """Return the end of a node, without the space and the comments behind it."""
    return Text(text).end_of(node) if not isinstance(node, ScalarNode) else _end_of_scalar(text, node)


def _end_of_scalar(text: str, node: ScalarNode) -> int:
    """Return the end of a scalar; libyaml lets some plain ones end after the space behind them."""
    start, end = int(node.start_mark.index), int(node.end_mark.index)
    return end if node.style in ("'", '"') else start + len(text[start:end].rstrip())


def replaced(text: str, node: Node, value: str, note: str) -> Replacement:
    """Write a text in place of a scalar, in the same quotes."""
    style = node.style if isinstance(node, ScalarNode) else None
    is_quotable = style in ("'", '"') and not set(value) & {"'", '"', "\\"}
    written = f"{style}{value}{style}" if is_quotable else scalar(value, in_flow=True)
    return Replacement(Edit(int(node.start_mark.index), end_of(text, node), written), line_of(node), note)


def number_replaced(text: str, node: Node, value: str, note: str) -> Replacement:
    """Write a number in place of a scalar."""
    return Replacement(Edit(int(node.start_mark.index), end_of(text, node), value), line_of(node), note)


# -- findings about paths -----------------------------------------------------------------------------------------


class Place(NamedTuple):
    """Place of a path in a file."""

    file: str
    line: int
    column: int

    @classmethod
    def of(cls, file: str, node: Node) -> "Place":
        """The place of a node."""
        return cls(file, line_of(node), int(node.start_mark.column) + 1)


def value_changes(
    file: str, text: str, nodes: Iterable[Node | None], move: tuple[str, str], migration: Migration, note: str
) -> Iterator[Outcome]:
    """Yield the changes of scalars that are named values of a signal: the new name, or the finding that it is gone.

    `move` is the old and the new path of the signal.
    """
    names, removed = migration.value_names(*move), migration.removed_values(*move)
    for node in nodes:
        if isinstance(node, ScalarNode) and node.value in names:
            yield replaced(text, node, names[node.value], f"{note}: {node.value} → {names[node.value]}")
        elif isinstance(node, ScalarNode) and node.value in removed:
            yield value_removed(move[0], node.value, Place.of(file, node))


def value_removed(path: str, value: str, place: Place) -> Finding:
    """The finding about a value that the new catalogue does not have."""
    fix = "Choose another value, or name it in `values` of a table."
    return not_convertible(path, place, f"the new tree does not have the value {value!r}.", fix)


def undecided(path: str, fate: Fate, place: Place, migration: Migration) -> Iterator[Finding]:
    """Yield the finding about a path whose new path is not certain."""
    if fate.status == "guess":
        others = [choice for choice in fate.choices if choice != fate.path]
        message = f"{path} probably moved to {fate.path} ({fate.confidence:.0%}). {fate.why}".strip()
        fix = f"Pass --accept-guesses, or --choose {path}={others[0] if others else fate.path}."
        yield codes.MOVE_GUESSED.finding(message, *place, path, fix=fix)
    elif fate.status == "choice":
        message = f"{path} has no certain successor: {', '.join(fate.choices)}. {fate.why}".strip()
        yield codes.MOVE_UNDECIDED.finding(message, *place, path, fix=f"Pass --choose {path}={fate.choices[0]}.")
    elif fate.status == "gone":
        near = migration.proposals(path)
        advice = f" Similar: {', '.join(near)}." if near else ""
        message = f"{path} was removed without a replacement. {fate.why}".strip()
        fix = f"Remove it, or pass --choose {path}=NEW.{advice}"
        yield codes.REPLACEMENT_MISSING.finding(message, *place, path, fix=fix)


def not_convertible(path: str, place: Place, reason: str, fix: str = "") -> Finding:
    """The finding about a value that cannot be converted."""
    return codes.VALUE_NOT_CONVERTIBLE.finding(f"{path}: {reason}", *place, path, fix=fix)
