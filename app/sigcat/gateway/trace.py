"""Moments become a trace, as `sigcat simulate` reads it, row by row; the rows of another trace may be added."""

import csv
import heapq
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.host.shapes import Number
from sigcat.catalogue.model.datatypes import PRIMITIVES
from sigcat.catalogue.network.mapped_signals import Mapped
from sigcat.errors import InputRefused
from sigcat.findings import Finding, shown
from sigcat.gateway.translation import Moment
from sigcat.limits import TRACE_ROW_BYTES
from sigcat.names import did_you_mean
from sigcat.runs.recording.cells import Unfit, value_of
from sigcat.runs.recording.csv_file import SPECIAL, quoted
from sigcat.runs.recording.times import nanoseconds, seconds


class Row(NamedTuple):
    """A row of a trace: texts of cells by the indexes of columns, of which the first one has 0."""

    time: int
    cells: Mapping[int, str]


def rows_of(moments: Iterable[Moment]) -> Iterator[Row]:
    """The rows of moments; each mapped signal is a column."""
    for time, values in moments:
        yield Row(time, {number: text for number, _, text in values})


def joined(rows: Iterable[Row]) -> Iterator[Row]:
    """Merge rows of equal time unless a column would get two values."""
    last: Row | None = None
    for row in rows:
        if last is not None and last.time == row.time and last.cells.keys().isdisjoint(row.cells):
            last = Row(row.time, {**last.cells, **row.cells})
            continue
        if last is not None:
            yield last
        last = row
    if last is not None:
        yield last


def lines_of(rows: Iterable[Row], columns: Sequence[str]) -> Iterator[str]:
    """The lines of the file."""
    yield f"time,{','.join(map(_quoted, columns))}\n"
    empty = [""] * len(columns)
    is_plain = SPECIAL.isdisjoint
    for time, cells in rows:
        texts = empty.copy()
        for index, text in cells.items():
            texts[index] = text if is_plain(text) else _quoted(text)
        yield f"{seconds(time)},{','.join(texts)}\n"


def _quoted(text: str) -> str:
    """A cell on one line, in quotes where it needs them."""
    return quoted(text).replace("\n", " ").replace("\r", " ")


# -- another trace ------------------------------------------------------------------------------------------------


class Added(NamedTuple):
    """A trace whose rows are added: its columns that no mapped signal has."""

    file: Path
    columns: tuple[str, ...]
    indexes: tuple[int, ...]
    """Indexes of these columns in the file."""
    shapes: Mapping[int, Number] = {}
    """Indexes of columns that are signals with numbers: their cells are checked."""
    findings: tuple[Finding, ...] = ()
    """Columns that may be misspelled: a function may define its own signals."""


def added_trace(file: Path, mapped: Iterable[Mapped], datatypes: Mapping[str, str] | None = None) -> Added:
    """A trace by its header, without known columns, by path or by the name of the interface. Raises InputRefused.

    Where datatypes of signals are known, a cell that does not fit its datatype is refused, and an unknown name is reported.
    """
    header = next(_cells(file), (1, []))[1]
    if not header or header[0].strip() != "time":
        raise _refused(_finding(file, 1, f"The first column must be `time`, not {shown(header[0] if header else '')}."))
    known = {"time", "call", *(name for each in mapped for name in (each.path, each.name))}
    taken = [(index, name.strip()) for index, name in enumerate(header) if name.strip() not in known]
    columns, indexes = tuple(name for _, name in taken), tuple(index for index, _ in taken)
    if datatypes is None:
        return Added(file, columns, indexes)
    unknown = tuple(
        codes.TRACE_MALFORMED.graded("warning").finding(
            f"The catalogue has no signal {shown(name)}.", str(file), 1, 1, fix=did_you_mean(name, datatypes)
        )
        for name in columns if name not in datatypes and ("." in name or "_" not in name)
    )  # fmt: skip
    shapes = {index: Number(datatypes[name]) for index, name in taken if datatypes.get(name, "string") in _NUMBERS}
    return Added(file, columns, indexes, shapes, unknown)


_NUMBERS = PRIMITIVES - {"string", "numeric"}


def trace_rows(file: Path) -> tuple[Iterator[Row], tuple[str, ...]]:
    """The rows of a trace, and its columns. Raises InputRefused, also while they are read."""
    added = added_trace(file, ())
    return _rows(added, 0), added.columns


def merged(rows: Iterable[Row], added: Added, first: int) -> Iterator[Row]:
    """Rows with those of another trace between them, by time; its columns begin at the index `first`."""
    return heapq.merge(rows, _rows(added, first), key=lambda row: row.time)


def _rows(added: Added, first: int) -> Iterator[Row]:
    last = 0
    cells = _cells(added.file)
    next(cells)
    for line, row in cells:
        time = nanoseconds(row[0]) if row else None
        if time is None or time < last or len(row) <= max(added.indexes, default=0):
            raise _refused(_finding(added.file, line, "The row must have a time that does not go back, and all cells."))
        last = time
        for index, shape in added.shapes.items():
            _check(row[index], shape, added.file, line)
        found = {first + number: row[index] for number, index in enumerate(added.indexes) if row[index]}
        if found:
            yield Row(time, found)


def _check(text: str, shape: Number, file: Path, line: int) -> None:
    """Raises InputRefused for a cell that is not a value."""
    if text:
        try:
            value_of(text, shape)
        except Unfit as reason:
            raise _refused(_finding(file, line, f"A cell {reason}.", reason.fix)) from None


def clock_doubt(added: Added, first: int) -> Finding | None:
    """Whether a trace and a log that begins at a time have the same clock."""
    row = next(_rows(added, 0), None)
    if row is None or abs(row.time - first) < _ANOTHER_CLOCK:
        return None
    message = (
        f"The trace begins at {row.time / 1e9:,.0f} s, and the log at {first / 1e9:,.0f} s: their rows do not meet."
    )
    return codes.TRACE_MALFORMED.graded("warning").finding(
        message, str(added.file), fix="Count the log from its first frame with --from-zero."
    )


_ANOTHER_CLOCK = 30 * 86400 * 10**9
"""No drive takes a month."""


def _cells(file: Path) -> Iterator[tuple[int, list[str]]]:
    """The rows of a CSV file that are not empty, with their lines."""
    csv.field_size_limit(TRACE_ROW_BYTES)
    with file.open(encoding="utf-8-sig", newline="") as data:
        reader = csv.reader(data)
        try:
            yield from ((reader.line_num, row) for row in reader if row)
        except (csv.Error, UnicodeDecodeError) as error:
            raise _refused(_finding(file, reader.line_num, f"The file must be CSV in UTF-8: {error}.")) from None


def _finding(file: Path, line: int, message: str, fix: str = "") -> Finding:
    return codes.TRACE_MALFORMED.finding(message, str(file), line, 1, fix=fix)


def _refused(finding: Finding) -> InputRefused:
    return InputRefused("The trace cannot be added.", (finding,))
