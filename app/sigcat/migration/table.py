"""Tables of moves: what became of the nodes of a release in the next one. A table is a YAML file.

Its format is documented in docs/reference/migration-tables.md.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import Builder, Unbuildable, position, read_document
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.importing.yaml_text import scalar
from sigcat.migration.labelled_path import LabelledPath, bracketed, moved, parsed, plain, template
from sigcat.open_files import read_bytes
from sigcat.text_lines import lines_of

_TABLES = Path(__file__).parent / "tables"
_KEYS = ("from", "to", "moves", "labels", "values")
CERTAIN = 1.0
_HEAD = 4_096
"""Bytes in which the first key of a table is searched."""


class Entry(NamedTuple):
    """New names of a node or a label. More than one, or none, is for a person to decide."""

    targets: tuple[str, ...]
    confidence: float = CERTAIN
    """From 0 to 1 (certain): how probable the first target is. 0: unknown."""
    why: str = ""


class Table(NamedTuple):
    """The moves from one release to another."""

    old: str
    new: str
    moves: Mapping[str, Entry]
    """By path, with labels in brackets."""
    labels: Mapping[str, Mapping[str, Entry]]
    """Labels of instances that changed, by the path of their branch as it was, without labels."""
    values: Mapping[str, Mapping[str, str]] = {}
    """New names of allowed values, by the path of their signal as it was, without labels."""

    @property
    def by_plain_path(self) -> Mapping[str, Entry]:
        """The moves with labels in brackets, by path as trees have it."""
        return {path.replace("[", ".").replace("]", ""): entry for path, entry in self.moves.items() if "[" in path}

    @property
    def inverse(self) -> "Table":
        """The way back. Where several nodes became one, each of them is possible."""
        return Table(
            self.new,
            self.old,
            _inverted(self.moves),
            {path: _inverted(entries) for path, entries in self.labels.items()},
            dict(map(self._inverted_values, self.values)),
        )

    def _inverted_values(self, path: str) -> tuple[str, Mapping[str, str]]:
        """Return the way back of the names of values, by the new path of their signal."""
        parts = parsed(path)
        step = applied(parts, self) if parts is not None else Step(None)
        names = {new: old for old, new in self.values[path].items()}
        return (template(step.path) if step.path is not None else path), names


class Step(NamedTuple):
    """A path after a table, with the entries that decided it. `targets` are the other possibilities."""

    path: LabelledPath | None
    confidence: float = CERTAIN
    why: str = ""
    choices: tuple[str, ...] = ()


def applied(path: LabelledPath, table: Table) -> Step:
    """Return what a table says about a path; the path itself where it says nothing."""
    for count in range(len(path), 0, -1):
        entry = _entry_of(path[:count], table)
        if entry is not None:
            return _moved(path[:count], path[count:], entry)
    return _relabelled(path, table)


def value_names(path: LabelledPath, tables: Iterable[Table]) -> dict[str, str]:
    """Return the new names of allowed values after several tables, by old name."""
    names: dict[str, str] = {}
    at: LabelledPath | None = path
    for table in tables:
        if at is None:
            break
        renamed = table.values.get(template(at), {})
        names = {
            old: renamed.get(new, new) for old, new in {**dict(zip(renamed, renamed, strict=True)), **names}.items()
        }
        at = applied(at, table).path
    return {old: new for old, new in names.items() if old != new}


def _entry_of(path: LabelledPath, table: Table) -> Entry | None:
    names = (bracketed(path), template(path))
    return next((table.moves[name] for name in names if name in table.moves), None) or table.by_plain_path.get(
        plain(path)
    )


def _moved(start: LabelledPath, rest: LabelledPath, entry: Entry) -> Step:
    targets = [moved(start, rest, target) for each in entry.targets if (target := parsed(each)) is not None]
    choices = tuple(map(bracketed, targets))
    if not targets or not entry.confidence:
        return Step(None, 0, entry.why, choices)
    return Step(targets[0], entry.confidence, entry.why, choices)


def _relabelled(path: LabelledPath, table: Table) -> Step:
    confidence, why, choices = CERTAIN, "", [path]
    for index, segment in enumerate(path):
        entries = table.labels.get(template(path[: index + 1]), {})
        for at, label in enumerate(segment.labels):
            entry = entries.get(label)
            if entry is not None:
                choices = [_with_label(each, index, at, target) for each in choices for target in entry.targets]
                confidence, why = min(confidence, entry.confidence), why or entry.why
    return Step(choices[0] if choices else None, confidence, why, tuple(map(bracketed, choices)))


def _with_label(path: LabelledPath, index: int, at: int, label: str) -> LabelledPath:
    labels = path[index].labels
    changed = path[index]._replace(labels=(*labels[:at], label, *labels[at + 1 :]))
    return (*path[:index], changed, *path[index + 1 :])


def _inverted(entries: Mapping[str, Entry]) -> dict[str, Entry]:
    sources: dict[str, list[tuple[str, Entry]]] = {}
    for source, entry in entries.items():
        for target in entry.targets[: 1 if entry.confidence else None]:
            sources.setdefault(target.replace("[*]", ""), []).append((source, entry))
    return {target: _joined(found) for target, found in sources.items()}


def _joined(found: list[tuple[str, Entry]]) -> Entry:
    """Return the way back to several nodes: to the first of them, if all were certain."""
    confidences = {entry.confidence for _, entry in found}
    confidence = confidences.pop() if len(found) == 1 or confidences == {CERTAIN} else 0.0
    return Entry(tuple(source for source, _ in found), confidence, found[0][1].why)


# -- shipped tables -----------------------------------------------------------------------------------------------


def release_of(catalogue: Catalogue) -> str:
    """Return the release of VSS that a tree says it is, such as `6.0`; empty if it says none."""
    parts = (catalogue.get(f"Vehicle.VersionVSS.{name}") for name in ("Major", "Minor"))
    numbers = [node.values.get("default") for node in parts if node is not None]
    return ".".join(map(str, numbers)) if len(numbers) == len(("Major", "Minor")) else ""


def tables_between(old: str, new: str) -> tuple[Table, ...]:
    """Return the shipped tables that lead from one release to another, in order; none if they do not."""
    shipped = shipped_tables()
    releases = [shipped[0].old, *(table.new for table in shipped)]
    if old not in releases or new not in releases:
        return ()
    start, end = releases.index(old), releases.index(new)
    if start <= end:
        return shipped[start:end]
    return tuple(table.inverse for table in reversed(shipped[end:start]))


@lru_cache(maxsize=1)
def shipped_tables() -> tuple[Table, ...]:
    """Return the tables of the official releases of VSS, from the oldest to the newest."""
    return tuple(read_table(path) for path in sorted(_TABLES.glob("*.yaml")))


# -- reading ------------------------------------------------------------------------------------------------------


def is_table(path: Path) -> bool:
    """Whether a file is a table of moves, by its first key."""
    if path.suffix not in (".yaml", ".yml"):
        return False
    with path.open("rb") as file:
        return re.match(rb"(?:\s*#[^\n]*\n|\s)*from:", file.read(_HEAD)) is not None


def read_table(path: Path) -> Table:
    """Read a table. Raises InputRefused with all findings."""
    name = str(path)
    document = read_document(read_bytes(path), name)
    if document.root is None:
        findings = document.findings or (_unfit(name, 1, "The file is empty."),)
        raise InputRefused(f"{name} cannot be used", findings)
    try:
        data = Builder().value(document.root)
    except Unbuildable as error:
        line, column = position(error.node)
        raise InputRefused(f"{name} cannot be used", (error.rule.finding(str(error), name, line, column),)) from None
    faults = list(_faults(data))
    if faults:
        raise InputRefused(
            f"{name} cannot be used", tuple(_unfit(name, _line(document.text, key), fault) for key, fault in faults)
        )
    labels = data.get("labels") or {}
    return Table(
        str(data["from"]),
        str(data["to"]),
        _entries(data.get("moves") or {}),
        {path: _entries(entries) for path, entries in labels.items()},
        data.get("values") or {},
    )


def _entries(data: Mapping[str, Any]) -> dict[str, Entry]:
    return {source: _entry(value) for source, value in data.items()}


def _entry(value: Any) -> Entry:
    if isinstance(value, str):
        return Entry((value,))
    return Entry(tuple(value["to"]), float(value.get("confidence", 0)), str(value.get("why", "")))


def _faults(data: Any) -> Iterator[tuple[str, str]]:
    """Yield the key of each problem of a table, and its message."""
    if not isinstance(data, dict):
        yield "", "A table must be a mapping with `from`, `to` and `moves`."
        return
    for key in ("from", "to"):
        if not isinstance(data.get(key), str):
            yield key, f"`{key}` must be the name of a release, in quotes."
    for key in data:
        if key not in _KEYS:
            yield str(key), f"Unknown key {str(key)!r}. Known are {', '.join(_KEYS)}."
    yield from _faults_of_entries(data.get("moves"), "moves")
    labels = data.get("labels") or {}
    for path, entries in labels.items() if isinstance(labels, dict) else (("labels", labels),):
        yield from _faults_of_entries(entries, str(path))
    yield from _faults_of_values(data.get("values"))


def _faults_of_values(values: Any) -> Iterator[tuple[str, str]]:
    if values is not None and not isinstance(values, dict):
        yield "values", "`values` must be a mapping."
        return
    for path, names in (values or {}).items():
        if not isinstance(path, str) or parsed(path) is None:
            yield str(path), f"{str(path)!r} is not a path."
        if not isinstance(names, dict) or not all(isinstance(each, str) for pair in names.items() for each in pair):
            yield str(path), f"{str(path)!r} must have the new name of each value by its old name, as texts."
        elif len(set(names.values())) < len(names):
            yield str(path), f"{str(path)!r} must not have one new name for two values."


def _faults_of_entries(entries: Any, key: str) -> Iterator[tuple[str, str]]:
    if entries is None:
        return
    if not isinstance(entries, dict):
        yield key, f"`{key}` must be a mapping."
        return
    for source, value in entries.items():
        targets = [value] if isinstance(value, str) else value.get("to") if isinstance(value, dict) else None
        if not isinstance(source, str) or parsed(source) is None:
            yield str(source), f"{str(source)!r} is not a path or label. Write labels of instances in brackets."
        if not isinstance(targets, list) or any(not isinstance(each, str) or parsed(each) is None for each in targets):
            yield str(source), f"{str(source)!r} must have a target, or `to` with a list of targets."
        elif isinstance(value, dict) and not _is_share(value.get("confidence", 0)):
            yield str(source), "`confidence` must be a number from 0 to 1."


def _is_share(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value <= 1


def _unfit(file: str, line: int, message: str) -> Finding:
    return codes.MIGRATION_TABLE_UNFIT.finding(message, file, line)


def _line(text: str, key: str) -> int:
    """Return the line that begins with a key; 1 if there is none."""
    lines = (n for n, line in enumerate(lines_of(text), 1) if line.lstrip().strip("'\"").startswith(key))
    return next(lines, 1) if key else 1


# -- writing ------------------------------------------------------------------------------------------------------


def table_text(table: Table) -> str:
    """Return a table as YAML, to be corrected by a person."""
    lines = [f"from: {scalar(table.old)}", f"to: {scalar(table.new)}", "moves:" if table.moves else "moves: {}"]
    for path, entry in table.moves.items():
        if entry.confidence == CERTAIN and len(entry.targets) == 1 and not entry.why:
            lines.append(f"  {path}: {entry.targets[0]}")
            continue
        lines += [f"  {path}:", f"    to: [{', '.join(entry.targets)}]"]
        lines += [f"    confidence: {entry.confidence}"] if entry.confidence else []
        lines += [f"    why: {scalar(entry.why)}"] if entry.why else []
    return "\n".join(lines) + "\n"
