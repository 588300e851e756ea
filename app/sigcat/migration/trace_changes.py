"""Changes of a recording in CSV: the paths of its columns, and their values in new units.

A recording has no units. Whether its values were converted before is known from `.sigcat-migrated`.
"""

import re
from collections.abc import Collection, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.findings import Finding
from sigcat.function.function_json.conversion import IDENTITY, Linear
from sigcat.migration.changed_text import Migrated, Place, not_convertible, undecided
from sigcat.migration.migration import Migration
from sigcat.migration.numbers import converted_value, is_whole, rounded

_CELL = re.compile(r'[ \t]*"[^"]*(?:""[^"]*)*"[ \t]*(?=,|$)|[^,]*(?=,|$)')
_NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")


class Column(NamedTuple):
    """A column whose values change."""

    path: str
    target: str
    conversion: Linear
    is_whole: bool
    """Whether the new datatype holds whole numbers only."""


def is_recording(data: bytes) -> bool:
    """Whether a file is a recording: its first column is the time."""
    return re.match(rb"(?:\xef\xbb\xbf)?\s*time\s*(?:,|\r?$)", data[:64], re.MULTILINE) is not None


def migrated_trace(file: str, data: bytes, migration: Migration, current: Collection[str] = ()) -> Migrated:
    """Change a recording. The values of `current` paths are those of the new catalogue already."""
    if not is_recording(data):
        return Migrated(file, data, data)
    text = data.decode("utf-8")
    header, *rows = text.splitlines(keepends=True) or [""]
    cells = _cells(header)
    names, findings, changes = list(cells), list[Finding](), list[tuple[int, str]]()
    columns: dict[int, Column] = {}
    paths = [_path(cell) for cell in cells]
    for index, path in enumerate(paths):
        target, found = _target(file, header, index, path, paths, migration)
        findings += found
        if target and target != path:
            names[index] = cells[index].replace(path, target)
            changes.append((1, f"`{path}` → `{target}`"))
        column = _column(path, target, migration) if target and path not in current else None
        if isinstance(column, Column):
            columns[index] = column
            changes.append((1, f"values of `{target}` in a new unit"))
        elif column is not None:
            findings.append(not_convertible(path, _place(file, 1, cells, index), column))
    lines = [_joined(names, header)]
    rounding: set[str] = set()
    for number, row in enumerate(rows, 2):
        lines.append(_row(row, columns, rounding, findings, file, number) if columns else row)
    return Migrated(
        file,
        data,
        "".join(lines).encode(),
        tuple(changes),
        tuple(findings),
        tuple(column.target for column in columns.values()),
    )


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


def _target(
    file: str, header: str, index: int, path: str, paths: Sequence[str], migration: Migration
) -> tuple[str, list[Finding]]:
    """Return the new path of a column, and what prevents it. Empty: the column stays."""
    if not migration.knows(path):
        return "", []
    place = _place(file, 1, _cells(header), index)
    fate = migration.fate(path, is_signal=True)
    if not fate.is_certain:
        return "", list(undecided(path, fate, place, migration))
    others = [other for other in paths if other != path and migration.knows(other)]
    met = [other for other in others if migration.fate(other, is_signal=True).path == fate.path]
    if fate.path != path and (met or fate.path in paths):
        message = f"{path} and {(met or [fate.path])[0]} both become {fate.path}."
        return "", [codes.MOVE_UNDECIDED.finding(message, *place, path, fix="Remove one of the columns.")]
    return fate.path, []


def _column(path: str, target: str, migration: Migration) -> Column | str | None:
    """Return how the values of a column change, why they cannot, or None if they stay."""
    both = migration.definitions(path, target)
    if both is None:
        return None
    old, new = both
    change = migration.unit_change(old.get("unit"), new.get("unit"))
    if change.conversion is None:
        return (
            f"the unit changed from {change.old} to {change.new}, without a conversion."
            if change.old and change.new
            else None
        )
    if change.conversion == IDENTITY:
        return None
    return Column(path, target, change.conversion, str(new.get("datatype")).removesuffix("[]") in INTEGER_RANGES)


def _row(
    row: str, columns: dict[int, Column], rounding: set[str], findings: list[Finding], file: str, number: int
) -> str:
    cells = _cells(row)
    for index, column in columns.items():
        if index < len(cells) and cells[index]:
            cell, is_rounded = _value(cells[index], column)
            if is_rounded and column.path not in rounding:
                rounding.add(column.path)
                findings.append(_rounded(column, _place(file, number, cells, index)))
            cells[index] = cell
    return _joined(cells, row)


def _rounded(column: Column, place: Place) -> Finding:
    message = f"Values of {column.path} are rounded to whole numbers from here on, which the new datatype needs."
    return codes.VALUE_ROUNDED.finding(message, *place, column.path)


def _value(cell: str, column: Column) -> tuple[str, bool]:
    """Return a cell in the new unit, number by number, and whether it was rounded."""
    is_rounded = False

    def converted(match: re.Match[str]) -> str:
        nonlocal is_rounded
        number = converted_value(match[0], column.conversion) or match[0]
        if column.is_whole and not is_whole(number):
            is_rounded, number = True, rounded(number)
        return number

    return _NUMBER.sub(converted, cell), is_rounded
