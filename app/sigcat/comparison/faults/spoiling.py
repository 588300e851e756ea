"""A trace with faults in it: pure, over rows of texts, so that every bit outside of the faults is unchanged."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.comparison.faults.scenario import Slow, Spoilt
from sigcat.runs.recording.times import seconds


class TextRow(NamedTuple):
    """A row of a trace."""

    time: int
    cells: tuple[str, ...]
    """One for each column."""


class TextTrace(NamedTuple):
    """A trace with the texts of its file."""

    columns: tuple[str, ...]
    """Without that of the time."""
    rows: tuple[TextRow, ...]


def spoil(trace: TextTrace, faults: Iterable[Spoilt], slow: Iterable[Slow]) -> TextTrace:
    """The trace with all faults in it. A column is added for a call that the trace says nothing of."""
    for fault in faults:
        trace = _spoilt(trace, fault)
    for each in slow:
        trace = _slow(trace, each)
    return trace


def _spoilt(trace: TextTrace, fault: Spoilt) -> TextTrace:
    column = trace.columns.index(fault.signal)
    if fault.kind == "sent":
        row = _with(TextRow(fault.start, ("",) * len(trace.columns)), column, fault.value)
        return trace._replace(rows=_in_order([*trace.rows, row]))
    kept: list[TextRow] = []
    late: list[TextRow] = []
    for row in trace.rows:
        is_met = row.cells[column] and fault.start <= row.time < fault.end
        kept += _kept(row, column, fault) if is_met else (row,)
        late += [_alone(row, column, row.time + fault.by)] if is_met and fault.kind == "delayed" else ()
    return trace._replace(rows=_in_order([*kept, *late]))


def _kept(row: TextRow, column: int, fault: Spoilt) -> Sequence[TextRow]:
    """Return the rows that replace a row within the fault."""
    if fault.kind == "value":
        return [_with(row, column, fault.value)]
    if fault.kind == "doubled":
        return [row, _alone(row, column, row.time)]
    rest = _with(row, column, "")
    return [rest] if any(rest.cells) else []


def _slow(trace: TextTrace, each: Slow) -> TextTrace:
    """Set a call's duration: a column whose value applies until the next one."""
    if each.call not in trace.columns:
        rows = tuple(row._replace(cells=(*row.cells, "")) for row in trace.rows)
        trace = TextTrace((*trace.columns, each.call), rows)
    column, empty = trace.columns.index(each.call), ("",) * len(trace.columns)
    told = [
        _with(TextRow(time, empty), column, text) for time, text in ((each.start, seconds(each.takes)), (each.end, "0"))
    ]
    return trace._replace(rows=_in_order([*told, *trace.rows]))


def _with(row: TextRow, column: int, cell: str) -> TextRow:
    return row._replace(cells=(*row.cells[:column], cell, *row.cells[column + 1 :]))


def _alone(row: TextRow, column: int, time: int) -> TextRow:
    cells = ("",) * len(row.cells)
    return _with(TextRow(time, cells), column, row.cells[column])


def _in_order(rows: Sequence[TextRow]) -> tuple[TextRow, ...]:
    """By time; rows of one time stay as they are."""
    return tuple(sorted(rows, key=lambda row: row.time))
