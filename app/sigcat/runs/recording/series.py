"""Values of one column in order of time, thinned while they come: it stays small whatever is recorded.

A value holds until another one comes, so that only changes are kept; of many in a short time the first, the smallest, the
largest and the last, and one that is not a number: what a picture can show of them. All values are counted. Of a window, the
points are those within it, and the value that holds when it begins.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat.limits import RUN_CHANGES, RUN_GAPS
from sigcat.runs.recording.times import LATEST

_SPANS = 2_000
"""Parts of the whole time that are separate; a picture has fewer columns of pixels."""
_MOST = 6 * _SPANS

Point = tuple[int, float]
"""A time in ns, and a value."""
Span = tuple[int, int]
"""Two times in ns."""
ALWAYS: Span = (0, LATEST)


class Series(NamedTuple):
    """Summary of a column's values."""

    points: tuple[Point, ...]
    """Changes within the window, the first value among them."""
    total: int
    """Values in all."""
    least: float
    greatest: float
    """Smallest and greatest of the finite values; NaN if there is none."""
    changes: tuple[Point, ...]
    """The first ones, none left out."""
    change_total: int
    last: float
    latest: int
    """Time of the last value."""
    gaps: tuple[Span, ...]
    """The first pauses between two values that are longer than the time-out, each from the end of that time."""
    gap_total: int

    @property
    def first(self) -> float:
        """The first value."""
        return self.changes[0][1]


class SeriesCollector:
    """Takes values as they come, in order of time."""

    def __init__(self, window: Span = ALWAYS, timeout: int = 0) -> None:
        self._window, self._timeout = window, timeout
        self._latest = 0
        self._gaps: list[Span] = []
        self._gap_total = 0
        self._points: list[Point] = []
        self._total = 0
        self._least, self._greatest = math.inf, -math.inf
        self._changes: list[Point] = []
        self._change_total = 0
        self._last: float | None = None

    def add(self, time: int, value: float) -> None:
        """One value."""
        self._note_gap(time)
        self._total += 1
        self._latest = time
        if value == self._last or (value != value and self._last != self._last):  # noqa: PLR0124 - NaN
            return
        self._last = value
        self._change_total += 1
        self._draw(time, value)
        if len(self._changes) < RUN_CHANGES:
            self._changes.append((time, value))
        if math.isfinite(value):
            self._least, self._greatest = min(self._least, value), max(self._greatest, value)
        if len(self._points) > _MOST:
            self._points = list(thinned(self._points))

    def _note_gap(self, time: int) -> None:
        """Keep the pause before a value if it is too long."""
        if self._timeout and self._total and time - self._latest > self._timeout:
            self._gap_total += 1
            if self._gap_total <= RUN_GAPS:
                self._gaps.append((self._latest + self._timeout, time))

    def _draw(self, time: int, value: float) -> None:
        """Keep the value if it is within the window, or holds when that begins."""
        first, last = self._window
        if time <= first:
            self._points = [(first, value)]
        elif time <= last:
            self._points.append((time, value))

    @property
    def series(self) -> Series:
        """Return the summary of the values so far."""
        has_numbers = self._least <= self._greatest
        least, greatest = (self._least, self._greatest) if has_numbers else (math.nan, math.nan)
        last = math.nan if self._last is None else self._last
        points, changes = tuple(self._points), tuple(self._changes)
        return Series(
            points, self._total, least, greatest, changes, self._change_total, last, self._latest, tuple(self._gaps),
            self._gap_total,
        )  # fmt: skip


def thinned(points: Sequence[Point]) -> Iterator[Point]:
    """The values that say the most, of each short span of time."""
    (start, _), (end, _) = points[0], points[-1]
    width = (end - start) // _SPANS + 1
    span: list[Point] = []
    until = start + width
    for point in points:
        if point[0] >= until:
            yield from _telling(span)
            span = []
            until = point[0] - (point[0] - start) % width + width
        span.append(point)
    yield from _telling(span)


def _telling(span: Sequence[Point]) -> Iterable[Point]:
    if len(span) <= 5:
        return span
    finite = [index for index, (_, value) in enumerate(span) if math.isfinite(value)]
    kept = {0, len(span) - 1}
    if finite:
        kept |= {min(finite, key=lambda index: span[index][1]), max(finite, key=lambda index: span[index][1])}
    if len(finite) < len(span):
        kept.add(next(index for index, (_, value) in enumerate(span) if not math.isfinite(value)))
    return [span[index] for index in sorted(kept)]
