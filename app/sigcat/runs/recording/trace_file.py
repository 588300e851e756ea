"""A trace is read: rows of a CSV file, each with a time and the values that came then. Everything wrong is a finding at
its line and column, and a file of any size is read row by row.
"""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType
from typing import BinaryIO, NamedTuple

from sigcat import codes
from sigcat.adapter.host.shapes import Shape, Value
from sigcat.errors import InputRefused
from sigcat.file_kind import RUN_COLUMNS
from sigcat.findings import Finding, RuleCode, has_errors, shown
from sigcat.limits import TRACE_FINDINGS, TRACE_ROW_BYTES
from sigcat.names import did_you_mean, question
from sigcat.runs.recording.cells import Unfit, value_of
from sigcat.runs.recording.times import LIMITS, nanoseconds, seconds

TIME, CALL = RUN_COLUMNS
"""Columns that every recording has: `call` is in what a simulation writes, and says nothing here."""


class Known(NamedTuple):
    """Columns that a trace may have."""

    received: Mapping[str, Shape]
    """Received values, by each of their names."""
    others: Collection[str] | None
    """Further known columns, which no function receives from a trace; None: any others, without a finding."""
    ends_rows: bool = False
    """Whether every row ends with a line break, as in what a run wrote: a row without one was cut, and its last cell
    may be."""
    inputs: tuple[tuple[str, ...], ...] = ()
    """The names of each input that a trace should have."""
    units: Mapping[str, str] = MappingProxyType({})
    """Units of received values, by each of their names."""
    unused: str = "the functions do not receive it, or one of them provides it"
    """Why one of the others is left out."""
    kinds: str = "neither a signal of the catalogue nor an interface of the functions"
    """Kinds of columns that are known, in messages about another one."""


class Moment(NamedTuple):
    """A row: the values at a time."""

    time: int
    values: tuple[tuple[str, Value], ...]
    """By the names of columns, in their order."""
    call: str = ""
    """In what a run wrote: the call that ended then."""
    line: int = 0
    """Line in its file."""


class Trace(NamedTuple):
    """A trace, of which the header was read."""

    file: Path
    columns: tuple[str, ...]
    shapes: tuple[Shape | None, ...]
    """Shape of each column; None: the column is left out."""
    findings: tuple[Finding, ...]
    taken: tuple[tuple[int, Shape], ...]
    """The columns that are not left out, by their indexes."""
    call: int | None
    """The index of the column of calls, if there is one."""
    ends_rows: bool
    """Whether a row without a line break at its end was cut."""
    known: Known | None = None
    """Known topics of a file in MCAP; None: it is CSV."""
    folder: "TemporaryDirectory[str] | None" = None
    """The folder of a converted file, which is removed with the trace."""
    bag: Path | None = None
    """The bag of ROS 2 that was converted."""

    def place(self, line: int, column: int) -> tuple[str, int, int]:
        """File, line and column of a finding. A bag has no lines."""
        return (str(self.file), line, column) if self.bag is None else (str(self.bag), 0, 0)


class _Row(NamedTuple):
    line: int
    text: str
    cells: Sequence[str]


def open_trace(file: Path, known: Known) -> Trace:
    """A trace by its header. Raises InputRefused if that cannot be used."""
    row = _header(file, ends_rows=known.ends_rows)
    if isinstance(row, Finding):
        raise refused(file, (row,))
    names = tuple(cell.strip() for cell in row.cells)
    most = TRACE_FINDINGS if known.others is None else None
    findings = tuple(islice(_Header(str(file), row, names, known).findings(), most))
    if has_errors(findings):
        raise refused(file, findings)
    shapes = tuple(known.received.get(name) for name in names)
    taken = tuple((index, shape) for index, shape in enumerate(shapes) if shape is not None)
    return Trace(file, names, shapes, findings, taken, names.index(CALL) if CALL in names else None, known.ends_rows)


def moments(trace: Trace) -> Iterator[Moment]:
    """The rows of a trace. Raises InputRefused at its end, with everything that was wrong with it."""
    lines = Lines(trace)
    with trace.file.open("rb") as data:
        lines.skip_header(data)
        while not lines.is_over and (line := data.readline(TRACE_ROW_BYTES + 1)):
            found = lines.moment(line)
            if found is not None:
                yield found
    lines.check()


class Lines:
    """Lines of a trace as they are read, and findings about them."""

    def __init__(self, trace: Trace) -> None:
        self.number = 0
        """Lines until now."""
        self.last = 0
        """Time of the last row."""
        self._trace, self._findings, self._is_broken = trace, list[Finding](), False

    @property
    def is_over(self) -> bool:
        """Whether no more lines should be read."""
        return self._is_broken or len(self._findings) >= TRACE_FINDINGS

    def skip_header(self, data: BinaryIO) -> None:
        """Read until after the header."""
        while self._row(data.readline(TRACE_ROW_BYTES + 1)) is None:
            pass

    def moment(self, line: bytes) -> Moment | None:
        """The row of a line, if it is not empty or wrong."""
        row = self._row(line)
        found = row if not isinstance(row, _Row) else _moment(self._trace, row, self.last, self._findings)
        if isinstance(found, Finding):
            self._findings.append(found)
            self._is_broken = isinstance(row, Finding)
            return None
        self.last = found.time if found else self.last
        return found

    def check(self) -> None:
        """Raise InputRefused if something is wrong."""
        if self._findings:
            raise refused(self._trace.bag or self._trace.file, tuple(self._findings))

    def _row(self, line: bytes) -> _Row | Finding | None:
        self.number += 1
        return _line(line, self.number, str(self._trace.file), ends_rows=self._trace.ends_rows)


def refused_trace(file: Path, message: str, fix: str) -> InputRefused:
    """The refusal of a whole file."""
    return refused(file, (codes.TRACE_MALFORMED.finding(message, str(file), fix=fix),))


def refused(file: Path, findings: tuple[Finding, ...]) -> InputRefused:
    """The refusal of a trace with these findings."""
    return InputRefused(f"{file} cannot be used as a trace.", findings)


# -- the header ---------------------------------------------------------------------------------------------------


class _Header(NamedTuple):
    file: str
    row: _Row
    names: tuple[str, ...]
    known: Known

    def findings(self) -> Iterator[Finding]:
        """Yield findings about the columns, and about those that are left out."""
        if not self.names or self.names[0] != TIME:
            first = self.names[0] if self.names else ""
            message = f"The first column must be `{TIME}`, not {shown(first)}." if first else "The trace has no header."
            yield self._finding(codes.TRACE_MALFORMED, 0, message, _fix_of_first(first))
            return
        seen = {TIME}
        for index, name in enumerate(self.names[1:], 1):
            yield from self._of_column(index, name, is_again=name in seen)
            seen.add(name)
        yield from missing_inputs(self.known, seen, self.file)

    def _of_column(self, index: int, name: str, *, is_again: bool) -> Iterator[Finding]:
        if is_again:
            message = f"The column {shown(name)} must be in the header only once."
            yield self._finding(codes.TRACE_MALFORMED, index, message, "Remove one of them.")
        elif name in self.known.received or name == CALL or self.known.others is None:
            return
        elif name in self.known.others:
            message = f"{name} is left out: {self.known.unused}."
            yield self._finding(codes.TRACE_COLUMN_UNUSED, index, message, "")
        else:
            known = [*self.known.received, *self.known.others]
            ending = re.compile(rf"(?i).*[._]{re.escape(name)}(_In)?")
            hint = did_you_mean(name, known) or question(sorted({*filter(ending.fullmatch, known)}, key=len)[:3])
            message = f"The column {shown(name)} is {self.known.kinds}."
            yield self._finding(codes.TRACE_COLUMN_UNKNOWN, index, message, hint or "Remove it.")

    def _finding(self, rule: RuleCode, index: int, message: str, fix: str) -> Finding:
        return rule.finding(message, self.file, self.row.line, _column(self.row, index), fix=fix)


def _fix_of_first(name: str) -> str:
    """The fix of a header whose first column is not the time."""
    if name.strip().casefold() == TIME:
        return f"Write `{TIME}`."
    if re.search("[;\t|]", name):
        return "Separate cells by commas."
    if not name.isprintable():
        return "Save the table as CSV: this file is not a text."
    return (
        "Write the header above this row." if nanoseconds(name) is not None else "Give the time of each row in seconds."
    )


def missing_inputs(known: Known, columns: Collection[str], file: str) -> Iterator[Finding]:
    """A note about inputs that a trace does not have."""
    missing = dict.fromkeys(names[0] for names in known.inputs if not set(names) & set(columns))
    if missing:
        message = f"The trace has no column for {', '.join(missing)}: the functions run with the start values."
        yield codes.INPUT_WITHOUT_COLUMN.finding(message, file, 1, 1)


# -- rows ---------------------------------------------------------------------------------------------------------


def column_in(trace: Trace, line: int, name: str) -> int:
    """Position of the cell of a column in a line, from 1."""
    with trace.file.open("rb") as data:
        text = next(islice(data, line - 1, None), b"").decode().rstrip("\r\n")
    return _column(_Row(line, text, ()), trace.columns.index(name))


def _moment(trace: Trace, row: _Row, last: int, findings: list[Finding]) -> Moment | Finding | None:
    """Return the values at the time of a row; findings of its cells are added to the list."""
    if len(row.cells) != len(trace.columns):
        message = f"The row must have {len(trace.columns)} cells, as the header has, not {len(row.cells)}."
        fix = _fix_of_count(row, len(trace.columns))
        return codes.TRACE_MALFORMED.finding(message, *trace.place(row.line, 1), fix=fix)
    time = nanoseconds(row.cells[0])
    if time is None or time < last:
        return _unfit_time(trace, row, last if time is not None else None)
    values = []
    for index, shape in trace.taken:
        cell = row.cells[index]
        if cell:
            try:
                values.append((trace.columns[index], value_of(cell, shape)))
            except Unfit as reason:
                findings.append(_unfit_value(trace, row, index, reason))
    return Moment(time, tuple(values), row.cells[trace.call] if trace.call is not None else "", row.line)


def _fix_of_count(row: _Row, count: int) -> str:
    """The fix of a row that has too few or too many cells."""
    if row.text.startswith("#"):
        return "Remove the line: a trace has no comments."
    if len(row.cells) == count + 1 and not row.cells[-1].strip():
        return "Remove the comma at the end."
    if any(cell.lstrip().startswith("[") and "]" not in cell for cell in row.cells):
        return "Put a list in quotation marks."
    return "Leave a cell empty that has no value. Write decimals with a point."


def _unfit_time(trace: Trace, row: _Row, above: int | None) -> Finding:
    """The finding about a time before that of the row above, in nanoseconds, or about a text that is not a time."""
    text = shown(row.cells[0])
    if above is None:
        message, fix = f"The time must be in seconds, {LIMITS}, not {text}.", "Write a number alone, such as 0.5."
    else:
        message = (
            f"The time must be at least {seconds(above).rstrip('0').rstrip('.')}, that of the row above, not {text}."
        )
        fix = "Sort the rows by time."
    return codes.TRACE_TIME_UNFIT.finding(message, *trace.place(row.line, _column(row, 0)), fix=fix)


def _unfit_value(trace: Trace, row: _Row, index: int, reason: Unfit) -> Finding:
    name = trace.columns[index]
    place = trace.place(row.line, _column(row, index))
    return codes.TRACE_VALUE_UNFIT.finding(f"{name} {reason}.", *place, path=name, fix=reason.fix)


def _header(file: Path, *, ends_rows: bool) -> _Row | Finding:
    """The first row that is not empty."""
    with file.open("rb") as data:
        lines = enumerate(iter(lambda: data.readline(TRACE_ROW_BYTES + 1), b""), 1)
        rows = (_line(line, number, str(file), ends_rows=ends_rows) for number, line in lines)
        return next((row for row in rows if row is not None), _Row(1, "", ()))


def _line(line: bytes, number: int, file: str, *, ends_rows: bool) -> _Row | Finding | None:
    """The row of a line; None if it is empty."""
    if len(line) > TRACE_ROW_BYTES:
        message = f"A row must be shorter than {TRACE_ROW_BYTES // 2**20} MiB."
        return codes.TRACE_MALFORMED.finding(message, file, number, 1)
    if ends_rows and not line.endswith(b"\n"):
        message = "The row must end with a line break: it was cut, perhaps within a number."
        return codes.TRACE_MALFORMED.finding(message, file, number, 1, fix="Write the file whole.")
    return _row(line.removeprefix(b"\xef\xbb\xbf") if number == 1 else line, number, file)


def _row(line: bytes, number: int, file: str) -> _Row | Finding | None:
    try:
        text = line.decode().rstrip("\r\n")
    except UnicodeDecodeError as error:
        message = "The file must be in UTF-8."
        return codes.TRACE_MALFORMED.finding(message, file, number, len(line[: error.start].decode()) + 1)
    if not text:
        return None
    if '"' not in text:
        return _Row(number, text, text.split(","))
    found = _quoted(text)
    if isinstance(found, int):
        message = "A cell that begins with a quote must end with one, in the same row; a quote within is doubled."
        fix = "Remove the quote, or close it."
        return codes.TRACE_MALFORMED.finding(message, file, number, found + 1, fix=fix)
    return _Row(number, text, [_unquoted(cell) for cell in found])


# -- cells --------------------------------------------------------------------------------------------------------

_CELL = re.compile(r'[ \t]*"[^"]*(?:""[^"]*)*"[ \t]*(?=,|$)|[^",]*(?=,|$)')


def _quoted(text: str) -> list[str] | int:
    """The cells of a row, unchanged, or where one begins that has no end."""
    cells: list[str] = []
    at = 0
    while at <= len(text):
        match = _CELL.match(text, at)
        if match is None:
            return at
        cells.append(match[0])
        at = match.end() + 1
    return cells


def _unquoted(cell: str) -> str:
    return cell.strip()[1:-1].replace('""', '"') if '"' in cell else cell


def _column(row: _Row, index: int) -> int:
    """Return the column at which a cell begins, from 1."""
    cells = row.text.split(",") if '"' not in row.text else _quoted(row.text)
    assert not isinstance(cells, int)
    return sum(len(cell) + 1 for cell in cells[:index]) + 1
