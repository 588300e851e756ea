"""Changes of a recording in CSV: the paths of its columns, and their values in new units.

A recording has no units. Whether its values were converted before is known from `.sigcat-migrated`.
"""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of
from sigcat.findings import Finding
from sigcat.function.function_json.conversion import IDENTITY, Linear
from sigcat.migration.changed_text import Migrated, Place, not_convertible, undecided, value_removed
from sigcat.migration.migration import Fate, Migration
from sigcat.migration.named_cells import names_in, renamed
from sigcat.migration.numbers import converted_value, is_whole, rounded

_CELL = re.compile(r'[ \t]*"[^"]*(?:""[^"]*)*"[ \t]*(?=,|$)|[^,]*(?=,|$)')
_NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")


class Conversion(NamedTuple):
    """The conversion of the values of a column."""

    path: str
    linear: Linear
    is_whole: bool
    """Whether the new datatype holds whole numbers only."""
    names: Mapping[str, str]
    """New names of values, by old name."""
    removed: frozenset[str] = frozenset()
    """Values that the new datatype does not have."""


class Column(NamedTuple):
    """A column after the migration: its cell in the header, its path, and how its values change."""

    name: str
    path: str
    conversion: Conversion | None = None
    notes: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()


class _Header(NamedTuple):
    """The header of a recording."""

    file: str
    cells: tuple[str, ...]
    migration: Migration
    current: Collection[str]

    @property
    def paths(self) -> list[str]:
        """Paths of the columns."""
        return [_path(cell) for cell in self.cells]


def is_recording(data: bytes) -> bool:
    """Whether a file is a recording: its first column is the time."""
    return re.match(rb"(?:\xef\xbb\xbf)?\s*time\s*(?:,|\r?$)", data[:64], re.MULTILINE) is not None


def migrated_trace(file: str, data: bytes, migration: Migration, current: Collection[str] = ()) -> Migrated:
    """Change a recording. The values of `current` paths are those of the new catalogue already."""
    if not is_recording(data):
        return Migrated(file, data, data)
    first, *rows = re.split(r"(?<=\n)", data.decode("utf-8"))
    header = _Header(file, tuple(_cells(first)), migration, current)
    columns = [_column(header, index) for index in range(len(header.cells))]
    for index, gone in _removed_values(file, rows, columns).items():
        columns[index] = Column(header.cells[index], header.paths[index], findings=gone)
    conversions = {index: each.conversion for index, each in enumerate(columns) if each.conversion is not None}
    findings = [finding for column in columns for finding in column.findings]
    lines = [_joined([column.name for column in columns], first), *_converted(rows, conversions, file, findings)]
    changes = tuple((1, note) for column in columns for note in column.notes)
    values = tuple(columns[index].path for index, each in conversions.items() if each.linear != IDENTITY)
    return Migrated(file, data, "".join(lines).encode(), changes, tuple(findings), values)


def _removed_values(file: str, rows: Sequence[str], columns: Sequence[Column]) -> Mapping[int, tuple[Finding, ...]]:
    """Return the findings about values that the new catalogue does not have, by column. Such a column stays as it is."""
    found: dict[int, dict[str, Finding]] = {}
    removed = {
        index: each.conversion for index, each in enumerate(columns) if each.conversion and each.conversion.removed
    }
    for number, row in enumerate(rows, 2) if removed else ():
        cells = _cells(row)
        for index, conversion in removed.items():
            for value in conversion.removed.intersection(names_in(cells[index])) if index < len(cells) else ():
                finding = value_removed(conversion.path, value, _place(file, number, cells, index))
                found.setdefault(index, {}).setdefault(value, finding)
    return {index: tuple(findings.values()) for index, findings in found.items()}


def _converted(
    rows: Sequence[str], conversions: Mapping[int, Conversion], file: str, findings: list[Finding]
) -> Iterator[str]:
    """Yield the rows in new units, and add findings about rounded columns."""
    rounded_paths: set[str] = set()
    for number, row in enumerate(rows, 2):
        cells = _cells(row) if conversions else []
        for index, conversion in conversions.items():
            if index < len(cells) and cells[index]:
                cell, is_rounded = _value(cells[index], conversion)
                if is_rounded and conversion.path not in rounded_paths:
                    rounded_paths.add(conversion.path)
                    findings.append(_rounded(conversion, _place(file, number, cells, index)))
                cells[index] = cell
        yield _joined(cells, row) if conversions else row


def _cells(line: str) -> list[str]:
    """Return the cells of a row, as they are written."""
    text = line.rstrip("\r\n")
    if '"' not in text:
        return text.split(",")
    cells, at = [], 0
    while at <= len(text):
        match = _CELL.match(text, at)
        if match is None:
            return text.split(",")
        cells.append(match[0])
        at = match.end() + 1
    return cells


def _joined(cells: Sequence[str], line: str) -> str:
    return ",".join(cells) + line[len(line.rstrip("\r\n")) :]


def _path(cell: str) -> str:
    return cell.strip().removeprefix("\ufeff").strip('"')


def _place(file: str, line: int, cells: Sequence[str], index: int) -> Place:
    return Place(file, line, sum(len(cell) + 1 for cell in cells[:index]) + 1)


def _column(header: _Header, index: int) -> Column:
    """Return a column after the migration; it stays where its path has no certain successor."""
    cell, path, migration = header.cells[index], header.paths[index], header.migration
    if not migration.knows(path):
        return Column(cell, path)
    place = _place(header.file, 1, header.cells, index)
    fate = migration.fate(path, is_signal=True)
    findings = tuple(
        undecided(path, fate, place, migration) if not fate.is_certain else _met(header, path, fate, place)
    )
    if findings:
        return Column(cell, path, findings=findings)
    moved = Column(cell.replace(path, fate.path), fate.path)
    notes = (f"`{path}` → `{fate.path}`",) if fate.path != path else ()
    conversion = _conversion(path, fate.path, migration) if path not in header.current else None
    if isinstance(conversion, str):
        return moved._replace(notes=notes, findings=(not_convertible(path, place, conversion),))
    if conversion is not None and (conversion.names or not conversion.removed):
        how = "with new names" if conversion.names else "in a new unit"
        notes = (*notes, f"values of `{fate.path}` {how}")
    return moved._replace(conversion=conversion, notes=notes)


def _met(header: _Header, path: str, fate: Fate, place: Place) -> Iterator[Finding]:
    """Yield the finding that another column has the same new path."""
    migration = header.migration
    others = [other for other in header.paths if other != path and migration.knows(other)]
    met = [other for other in others if migration.fate(other, is_signal=True).path == fate.path]
    if fate.path != path and (met or fate.path in header.paths):
        message = f"{path} and {(met or [fate.path])[0]} both become {fate.path}."
        yield codes.MOVE_UNDECIDED.finding(message, *place, path, fix="Remove one of the columns.")


def _conversion(path: str, target: str, migration: Migration) -> Conversion | str | None:
    """Return how the values of a column change, why they cannot, or None if they stay."""
    both = migration.definitions(path, target)
    if both is None:
        return None
    old, new = both
    change = migration.unit_change(old.get("unit"), new.get("unit"))
    if change.conversion is None and change.old and change.new:
        return f"the unit changed from {change.old} to {change.new}, without a conversion."
    names, removed = migration.value_names(path, target), migration.removed_values(path, target)
    if change.conversion in (None, IDENTITY) and not names and not removed:
        return None
    is_whole = element_of(str(new.get("datatype"))) in INTEGER_RANGES
    return Conversion(path, change.conversion or IDENTITY, is_whole, names, removed)


def _rounded(conversion: Conversion, place: Place) -> Finding:
    message = f"Values of {conversion.path} are rounded to whole numbers from here on, which the new datatype needs."
    return codes.VALUE_ROUNDED.finding(message, *place, conversion.path)


def _value(cell: str, conversion: Conversion) -> tuple[str, bool]:
    """Return a cell in the new unit, number by number, and whether it was rounded."""
    if conversion.names or conversion.removed:
        return renamed(cell, conversion.names), False
    is_rounded = False

    def converted(match: re.Match[str]) -> str:
        nonlocal is_rounded
        number = converted_value(match[0], conversion.linear) or match[0]
        if conversion.is_whole and not is_whole(number):
            is_rounded, number = True, rounded(number)
        return number

    return _NUMBER.sub(converted, cell), is_rounded
