"""Values of a trace that are outside of the range of their signal: they are passed on, and one note counts them."""

from collections.abc import Iterable, Iterator, Mapping
from math import inf
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.host.ranges import Range
from sigcat.findings import Finding
from sigcat.runs.recording.trace_file import Moment, Trace, column_in


class Outside(NamedTuple):
    """Values of a column that are outside, and where the first one is. The line is 0 in MCAP."""

    number: int
    line: int
    time: int


class OutsideValues:
    """The values of a trace that are outside of the ranges of their columns, counted while it is read."""

    def __init__(self, ranges: Mapping[str, Range]) -> None:
        self.ranges = ranges
        self._found: dict[str, Outside] = {}

    def looked_at(self, moments: Iterable[Moment]) -> Iterator[Moment]:
        """Yield rows unchanged, after their values were looked at."""
        for moment in moments:
            self.look_at(moment)
            yield moment

    def look_at(self, moment: Moment) -> None:
        """Count the values of a row that are outside."""
        for column, value in moment.values:
            held = self.ranges.get(column)
            if held is not None and not held.holds(value):
                self.add(column, Outside(1, moment.line, moment.time))

    def add(self, column: str, found: Outside) -> None:
        """Add values of a column; the earliest is kept as the first one."""
        known = self._found.get(column, found._replace(number=0))
        first = min(known, found, key=lambda each: (each.time, each.line))
        self._found[column] = first._replace(number=known.number + found.number)

    def findings(self, trace: Trace) -> Iterator[Finding]:
        """Yield a note for each column, at its first value that is outside."""
        for column, found in self._found.items():
            held = self.ranges[column]
            count = "1 value is" if found.number == 1 else f"{found.number:,} values are"
            message = f"{column}: {count} outside of the range {_written(held)} of the signal, the first at {found.time / 1e9:g} s."
            at = (found.line, column_in(trace, found.line, column)) if found.line else (0, 0)
            yield codes.TRACE_VALUE_OUTSIDE_RANGE.finding(message, *trace.place(*at), column)


def _written(held: Range) -> str:
    if held.least == -inf:
        return f"up to {held.greatest:g}"
    return f"from {held.least:g}" if held.greatest == inf else f"{held.least:g} to {held.greatest:g}"
