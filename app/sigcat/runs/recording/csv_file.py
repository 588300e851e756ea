"""Rows written as CSV: `time`, `call`, then a column for each thing that is sent. An empty cell is not a new value."""

from collections.abc import Iterable, Iterator, Mapping

from sigcat.adapter.host.shapes import Shape
from sigcat.runs.recording.cells import cell_of
from sigcat.runs.recording.recorded import Recorded, split
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import CALL, TIME


def csv_header(columns: Iterable[str]) -> str:
    """The first line."""
    return _line([TIME, CALL, *columns])


def csv_lines(rows: Iterable[Recorded], columns: Mapping[str, Shape]) -> Iterator[str]:
    """Lines of rows. The same rows give the same bytes."""
    places = {name: index for index, name in enumerate(columns, 2)}
    for row in rows:
        for each in split(row) if _has_doubles(row) else (row,):
            cells = [seconds(each.time), each.call, *[""] * len(columns)]
            for name, value in each.values:
                cells[places[name]] = cell_of(value, columns[name])
            yield _line(cells)


def _has_doubles(row: Recorded) -> bool:
    return len({name for name, _ in row.values}) < len(row.values)


def _line(cells: Iterable[str]) -> str:
    return ",".join(map(quoted, cells)) + "\n"


def quoted(cell: str) -> str:
    """A cell, in quotes where it needs them."""
    if SPECIAL.isdisjoint(cell):
        return cell
    doubled = cell.replace('"', '""')
    return f'"{doubled}"'


SPECIAL = frozenset(',"\r\n')
"""Characters of a cell that needs quotes."""
