"""Pictures of a report as SVG: distributions, and traces over each other. Colours and lines are classes of the page's style.

The separate page and that of the service have the same picture. A table shows its data, too.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from html import escape
from typing import NamedTuple

from sigcat.comparison.report.model import Durations, Line, Trace
from sigcat.comparison.report.words import duration
from sigcat.comparison.timing import BINS_PER_DECADE

LEFT, WIDTH, RIGHT = 210, 720, 34
_ROW, _HILL = 46, 30
_PANEL, _GAP = 110, 46
SERIES = 7
"""Kinds of lines; more platforms repeat them."""


class Row(NamedTuple):
    """A distribution and what it is of; rows of one series have one colour."""

    label: str
    series: int
    durations: Durations


class Mark(NamedTuple):
    """A duration that is drawn as a line through all rows, such as one of the paper."""

    at: float
    label: str


def distributions(title: str, rows: Sequence[Row], marks: Sequence[Mark] = ()) -> str:
    """Rows on one logarithmic axis: a hill for each, its median and its 99th percentile as lines."""
    if not rows:
        return ""
    low, high = _decades(rows, marks)
    top = 30
    height = top + _ROW * len(rows) + 40
    parts = [_opened(LEFT + WIDTH + RIGHT, height, title)]
    bottom = top + _ROW * len(rows)
    for power in range(low, high + 1):
        x = _x(10.0**power, low, high)
        parts.append(f'<path class="mark" d="M{x:g} {top - 6}V{bottom}"/>')
        parts.append(f'<text class="minor middle" x="{x:g}" y="{bottom + 18}">{duration(10.0**power)}</text>')
    for index, row in enumerate(rows):
        parts += _hill(row, top + _ROW * (index + 1) - 8, low, high)
    for mark in marks:
        x = _x(mark.at, low, high)
        parts.append(f'<path class="paper" d="M{x:g} {top - 6}V{bottom}"/>')
        anchor, shift = ("end", -5) if x > LEFT + WIDTH / 2 else ("start", 5)
        parts.append(f'<text class="minor {anchor}" x="{x + shift:g}" y="{top - 10}">{escape(mark.label)}</text>')
    return "".join([*parts, "</svg>"])


def _decades(rows: Sequence[Row], marks: Sequence[Mark]) -> tuple[int, int]:
    least = min([row.durations.least for row in rows] + [mark.at for mark in marks])
    worst = max([row.durations.worst for row in rows] + [mark.at for mark in marks])
    low = math.floor(math.log10(max(least, 10.0)))
    return low, max(math.ceil(math.log10(max(worst, 10.0))), low + 1)


def _x(value: float, low: int, high: int) -> float:
    share = (math.log10(max(value, 10.0)) - low) / (high - low)
    return round(LEFT + WIDTH * min(max(share, 0.0), 1.0), 1)


def _hill(row: Row, base: int, low: int, high: int) -> Iterator[str]:
    """The histogram as steps; heights are shares of its highest bin."""
    found = row.durations
    highest = max(found.bins, default=0) or 1
    path = f"M{_x(10 ** (found.first_bin / BINS_PER_DECADE), low, high):g} {base}"
    for index, count in enumerate(found.bins):
        end = _x(10 ** ((found.first_bin + index + 1) / BINS_PER_DECADE), low, high)
        up = max(_HILL * count / highest, 1.0) if count else 0.0
        path += f"V{base - up:.4g}H{end:g}"
    words = f"{row.label}: median {duration(found.p50)}, p99 {duration(found.p99)}, worst {duration(found.worst)}"
    yield f"<g><title>{escape(words)}, of {found.total:,}</title>"
    yield f'<text class="end" x="{LEFT - 10}" y="{base - 8}">{escape(row.label)}</text>'
    yield f'<path class="hill series-{row.series % SERIES}" d="{path}V{base}Z"/>'
    for value, name in ((found.p50, "median"), (found.p99, "p99")):
        yield f'<path class="{name}" d="M{_x(value, low, high):g} {base - _HILL - 4}V{base + 3}"/>'
    yield "</g>"


# -- traces -------------------------------------------------------------------------------------------------------


def traces(found: Sequence[Trace], titles: Mapping[str, str]) -> str:
    """A panel for each signal; in it a line for each platform, the later ones thinner, so that all are seen where they agree."""
    if not found:
        return ""
    times = [time for trace in found for line in trace.lines for time, _ in line.points]
    first, last = (min(times), max(times)) if times else (0, 1)
    last = max(last, first + 1)
    names = list(dict.fromkeys(line.platform for trace in found for line in trace.lines))
    places = _legend_places([titles.get(name, name) for name in names])
    top = max((place.y for place in places), default=16) + 38
    height = top + len(found) * (_PANEL + _GAP) + 6
    parts = [_opened(LEFT + WIDTH + RIGHT, height, "Signals of all platforms over each other")]
    parts += _legend(places)
    for index, trace in enumerate(found):
        parts += _panel(trace, names, top + index * (_PANEL + _GAP), first, last)
    parts += _seconds(first, last, top + len(found) * (_PANEL + _GAP) - _GAP)
    return "".join([*parts, "</svg>"])


def _opened(width: int, height: int, title: str) -> str:
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    return f'<svg class="diagram comparison" {size} role="img" aria-label="{escape(title)}">'


class _Place(NamedTuple):
    title: str
    x: int
    y: int


def _legend_places(titles: Sequence[str]) -> list[_Place]:
    """Places of titles, in rows as wide as the drawing."""
    places: list[_Place] = []
    x, y = 10, 16
    for title in titles:
        width = 64 + 7 * len(title)
        if x + width > LEFT + WIDTH + RIGHT:
            x, y = 10, y + 22
        places.append(_Place(title, x, y))
        x += width
    return places


def _legend(places: Sequence[_Place]) -> Iterator[str]:
    for index, (title, x, y) in enumerate(places):
        yield f'<path class="trace series-{index % SERIES}" d="M{x} {y}h34"/>'
        yield f'<text x="{x + 42}" y="{y + 4}">{escape(title)}</text>'


def _panel(trace: Trace, names: Sequence[str], top: int, first: int, last: int) -> Iterator[str]:
    values = [value for line in trace.lines for _, value in line.points if value is not None and math.isfinite(value)]
    low, high = _range(values)
    title = f"{trace.name} [{trace.unit}]" if trace.unit else trace.name
    yield f'<text class="strong" x="{LEFT}" y="{top - 7}">{escape(title)}</text>'
    for value, label in _marks(trace, values, low, high):
        y = top + _PANEL * (1 - (value - low) / (high - low))
        yield f'<path class="mark" d="M{LEFT} {y:.5g}h{WIDTH}"/>'
        yield f'<text class="minor end" x="{LEFT - 10}" y="{y + 4:.5g}">{escape(label)}</text>'
    yield f'<rect class="frame" x="{LEFT}" y="{top}" width="{WIDTH}" height="{_PANEL}"/>'
    for line in trace.lines:
        path = _path(line, first, last, low, high, top)
        if path:
            yield f'<path class="trace series-{names.index(line.platform) % SERIES}" d="{path}"/>'


def _range(values: Sequence[float]) -> tuple[float, float]:
    low, high = min(values, default=0.0), max(values, default=1.0)
    room = 0.06 * (high - low) or 0.5
    return low - room, high + room


def _marks(trace: Trace, values: Sequence[float], low: float, high: float) -> Iterator[tuple[float, str]]:
    if trace.words:
        yield from ((value, trace.words.get(round(value), f"{value:g}")) for value in sorted(set(values)))
        return
    span = high - low
    size = 10.0 ** math.floor(math.log10(span / 4))
    step = next(size * factor for factor in (1, 2, 5, 10) if span / (size * factor) <= 4)
    for number in range(math.ceil(low / step), math.floor(high / step) + 1):
        yield number * step, f"{number * step:.6g}".replace("-", "\u2212")


def _path(line: Line, first: int, last: int, low: float, high: float, top: int) -> str:
    """Steps: a value holds until another one comes. A value that is not a number leaves a gap."""
    path, is_open = "", False
    before_y = ""
    for time, value in line.points:
        x = f"{LEFT + WIDTH * (time - first) / (last - first):.5g}"
        if value is None or not math.isfinite(value):
            path += f"H{x}" if is_open else ""
            is_open = False
            continue
        y = f"{top + _PANEL * (1 - (value - low) / (high - low)):.5g}"
        if not is_open:
            path += f"M{x} {y}"
        elif y != before_y:
            path += f"H{x}V{y}"
        before_y, is_open = y, True
    return path + (f"H{LEFT + WIDTH}" if is_open else "")


def _seconds(first: int, last: int, bottom: int) -> Iterator[str]:
    span = (last - first) / 1e9
    size = 10.0 ** math.floor(math.log10(span / 8)) if span > 0 else 1.0
    step = next(size * factor for factor in (1, 2, 5, 10) if span / (size * factor) <= 8)
    for number in range(math.ceil(first / 1e9 / step), math.floor(last / 1e9 / step) + 1):
        x = LEFT + WIDTH * (number * step - first / 1e9) / span
        yield f'<text class="minor middle" x="{x:.5g}" y="{bottom + 18}">{number * step:g}</text>'
    yield f'<text class="minor middle" x="{LEFT + WIDTH / 2:g}" y="{bottom + 36}">seconds</text>'
