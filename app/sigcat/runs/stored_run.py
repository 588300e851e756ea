"""A run that was stored is read again, as far as it has to do with one function: nothing is built, and nothing runs."""

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.limits import RUN_BYTES
from sigcat.runs.columns import Column, FunctionColumns
from sigcat.runs.recording.series import ALWAYS, Series, SeriesCollector, Span
from sigcat.runs.recording.trace_file import Known, Moment, Trace, moments, open_trace


class CallTimes(NamedTuple):
    """Number and times of a call's runs. Times are in ns."""

    name: str
    total: int
    first: int
    last: int
    longest: int
    """Longest time from one to the next; 0 if there are fewer than two."""
    longest_from: int


class StoredRun(NamedTuple):
    """Content of a stored run."""

    first: int
    last: int
    """Times of the first and the last row, in ns."""
    rows: int
    series: Mapping[str, Series]
    """Requested columns that have values, in the requested order."""
    calls: tuple[CallTimes, ...]
    """Calls of the function, in its order."""
    findings: tuple[Finding, ...]
    """Findings about unreadable parts; the rest was read."""


def read_run(
    file: Path,
    name: str,
    wanted: Sequence[str],
    function: FunctionColumns,
    window: Span = ALWAYS,
    *,
    is_run: bool = True,
) -> StoredRun:
    """Some columns of a run and the calls of a function; `name` is what findings call the file.

    Any other recording (`is_run` false) may end without a line break. Of a window, the series have their points.

    Raises InputRefused if nothing of it can be read, and OSError.
    """
    if os.stat(file).st_size > RUN_BYTES:  # noqa: PTH116 - the same as of an open file
        raise InputRefused(f"The run must have at most {RUN_BYTES // 2**20} MiB to be drawn.")
    columns = {each: function.columns[each] for each in wanted}
    try:
        known = Known({each: column.shape for each, column in columns.items()}, None, ends_rows=is_run)
        trace = open_trace(file, known)
    except InputRefused as refused:
        raise InputRefused("The run cannot be read.", _called(refused.findings, name)) from None
    return _Reading(trace, columns, function.calls, window).read(name)


def _called(findings: Sequence[Finding], name: str) -> tuple[Finding, ...]:
    """Findings that do not say where on its machine the service has the file."""
    return tuple(finding._replace(file=name) for finding in findings)


class _Reading:
    def __init__(self, trace: Trace, columns: Mapping[str, Column], calls: Sequence[str], window: Span) -> None:
        self._trace = trace
        self._columns = columns
        self._series = {name: SeriesCollector(window, each.timeout) for name, each in columns.items()}
        self._calls = {call: _CallCollector() for call in calls}
        self._first, self._last, self._rows = -1, 0, 0

    def read(self, name: str) -> StoredRun:
        """The whole file, or as much of it as there is."""
        findings: Sequence[Finding] = ()
        try:
            for row in moments(self._trace):
                self._take(row)
        except InputRefused as refused:
            findings = refused.findings
        made = {each: collector.series for each, collector in self._series.items()}
        series = {each: found for each, found in made.items() if found.total}
        calls = tuple(each.times(call) for call, each in self._calls.items() if each.total)
        return StoredRun(max(self._first, 0), self._last, self._rows, series, calls, _called(findings, name))

    def _take(self, row: Moment) -> None:
        self._first = row.time if self._first < 0 else self._first
        self._last = row.time
        self._rows += 1
        own = self._calls.get(row.call)
        if own is not None:
            own.add(row.time)
        for name, value in row.values:
            if own is not None or not row.call or self._columns[name].is_shared:
                self._series[name].add(row.time, value)


class _CallCollector:
    def __init__(self) -> None:
        self.total = 0
        self._first = self._last = self._longest = self._longest_from = 0

    def add(self, time: int) -> None:
        """It was called."""
        if self.total and time - self._last > self._longest:
            self._longest, self._longest_from = time - self._last, self._last
        self._first = self._first if self.total else time
        self._last = time
        self.total += 1

    def times(self, name: str) -> CallTimes:
        """When it was called until now."""
        return CallTimes(name, self.total, self._first, self._last, self._longest, self._longest_from)
