"""Signals over time, as places in a picture: a panel for each, below each other, on one axis of time.

A value holds until the next one comes. Where there are more values than columns of pixels, a column shows the smallest and the
largest of them, so that no peak is lost and a picture of hours stays small.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from sigcat.adapter.host.shapes import Number, Shape
from sigcat.runs.recording.samples import Sample
from sigcat.runs.recording.times import NANOSECONDS

LEFT, WIDTH, RIGHT = 110, 820, 20
TOP, HEIGHT, GAP = 24, 110, 44
_FOOT = 44
_STEPS = 5
"""Steps of an axis, about."""
_FARTHEST, _NEAREST = 1e307, 1e-300
"""Largest value of an axis, and its smallest range: within them, differences and shares are numbers."""


class Tick(NamedTuple):
    """A mark on an axis, in pixels, and its label."""

    at: float
    label: str


class Panel(NamedTuple):
    """One signal."""

    title: str
    top: int
    ticks: tuple[Tick, ...]
    """On its own axis; places from the top of the picture."""
    path: str
    """Commands of an SVG path."""
    beside: str = ""
    """Commands of a second line, such as an expected one."""
    limits: tuple[Tick, ...] = ()
    """Limits of the valid range that are near the values."""


class Picture(NamedTuple):
    """All of them."""

    panels: tuple[Panel, ...]
    ticks: tuple[Tick, ...]
    """On the axis of time, in seconds."""
    width: int
    height: int
    first: float
    last: float
    """Range of the axis of time, in ns."""


class _Axis(NamedTuple):
    low: float
    high: float

    def share(self, value: float) -> float:
        """Return the position of a value on the axis, from 0 to 1."""
        return min(max((value - self.low) / (self.high - self.low), 0.0), 1.0) if self.low < self.high else 0.0


Beside = Mapping[str, Sequence[tuple[int, float]]]
"""Points of second lines, by name."""
Limits = Mapping[str, Sequence[float]]
"""Limits of valid ranges, by name."""


def picture(
    names: Sequence[str], shapes: Mapping[str, Shape], units: Mapping[str, str], found: Iterable[Sample],
    beside: Beside = MappingProxyType({}), limits: Limits = MappingProxyType({}),
) -> Picture:  # fmt: skip
    """The picture of the signals of these names, which are numbers."""
    points: dict[str, list[tuple[int, float]]] = {name: [] for name in names}
    first, last = math.inf, -math.inf
    for time, name, value in found:
        first, last = min(first, time), max(last, time)
        if name in points:
            points[name].append((time, float(value)))
    times = _Axis(first, last) if first < last else _Axis(*(_alone(first) if first <= last else (0, NANOSECONDS)))
    panels = tuple(
        _panel(index, name, points[name], beside.get(name, ()), times, shapes[name], units, limits.get(name, ()))
        for index, name in enumerate(names)
    )
    height = TOP + len(names) * (HEIGHT + GAP) - GAP + _FOOT
    return Picture(panels, _time_ticks(times), LEFT + WIDTH + RIGHT, height, times.low, times.high)


def _alone(time: float) -> tuple[float, float]:
    return time, time + NANOSECONDS


def _panel(
    index: int, name: str, points: Sequence[tuple[int, float]], beside: Sequence[tuple[int, float]], times: _Axis,
    shape: Shape, units: Mapping[str, str], limits: Sequence[float],
) -> Panel:  # fmt: skip
    assert isinstance(shape, Number)
    top = TOP + index * (HEIGHT + GAP)
    both = [*points, *beside]
    named = _values_with_names(shape, both)
    near = () if named is not None else _near(limits, both)
    axis = _range([*both, *((0, each) for each in near)], named)
    ticks = named if named is not None else [(value, _short(value)) for value in _round_steps(axis)]
    placed = tuple(Tick(_y(value, axis, top), label) for value, label in ticks)
    unit = units.get(name, "").replace("^2", "²").replace("^3", "³")
    return Panel(
        f"{name} [{unit}]" if unit else name,
        top,
        placed,
        _path(points, times, axis, top),
        _path(beside, times, axis, top),
        tuple(Tick(_y(each, axis, top), _short(float(f"{each:.6g}"))) for each in near),
    )


def _values_with_names(shape: Number, points: Sequence[tuple[int, float]]) -> list[tuple[float, str]] | None:
    """The values of an enumeration or a boolean that occur, with their names; None for a number."""
    symbols = {number: symbol for symbol, number in shape.symbols} or {0: "false", 1: "true"}
    if not shape.symbols and shape.datatype != "boolean":
        return None
    return [(value, symbols.get(round(value), _short(value))) for value in sorted({value for _, value in points})]


def _range(points: Sequence[tuple[int, float]], named: list[tuple[float, str]] | None) -> _Axis:
    """From the smallest to the largest finite value, with some room."""
    values = [min(max(value, -_FARTHEST), _FARTHEST) for _, value in points if math.isfinite(value)] or [0.0]
    low, high = min(values), max(values)
    room = 0.3 if named is not None else max(0.05 * (high - low) or 0.05 * abs(high) or 1.0, _NEAREST)
    return _Axis(low - room, high + room)


def _near(limits: Sequence[float], points: Sequence[tuple[int, float]]) -> list[float]:
    """The limits that values pass, or come nearer to than their own range: others would flatten the line."""
    values = [value for _, value in points if math.isfinite(value)]
    if not values:
        return []
    low, high = min(values), max(values)
    return [each for each in limits if 2 * low - high <= each <= 2 * high - low]


def _y(value: float, axis: _Axis, top: int) -> float:
    return round(top + HEIGHT * (1 - axis.share(value)), 2)


# -- lines --------------------------------------------------------------------------------------------------------


def _path(points: Sequence[tuple[int, float]], times: _Axis, axis: _Axis, top: int) -> str:
    """Steps: a value holds until another one comes. NaN and infinities leave a gap."""
    parts: list[str] = []
    before = None
    for x, value in _columns(points, times):
        if not math.isfinite(value):
            parts += [f"H{x:g}"] if before is not None else []
            before = None
            continue
        y = _y(value, axis, top)
        if y != before:
            parts.append(f"M{x:g} {y:g}" if before is None else f"H{x:g}V{y:g}")
        before = y
    return "".join([*parts, f"H{LEFT + WIDTH}" if before is not None else ""])


def _columns(points: Sequence[tuple[int, float]], times: _Axis) -> Iterable[tuple[float, float]]:
    """Values by their columns of pixels: of more than four in one, the first, the extremes and the last."""
    columns: dict[int, list[tuple[float, float]]] = {}
    for time, value in points:
        x = LEFT + WIDTH * times.share(time)
        columns.setdefault(int(x), []).append((x, value))
    for column, placed in columns.items():
        values = [value for _, value in placed]
        if len(placed) <= 4:
            yield from ((round(x, 2), value) for x, value in placed)
        else:
            yield from ((column, value) for value in (values[0], min(values), max(values), values[-1]))


# -- axes ---------------------------------------------------------------------------------------------------------


def _time_ticks(times: _Axis) -> tuple[Tick, ...]:
    in_seconds = _Axis(times.low / NANOSECONDS, times.high / NANOSECONDS)
    marks = _round_steps(in_seconds, 2 * _STEPS)
    return tuple(Tick(round(LEFT + WIDTH * in_seconds.share(mark), 2), _short(mark)) for mark in marks)


def _round_steps(axis: _Axis, count: int = _STEPS) -> list[float]:
    """Round numbers within an axis, about so many."""
    span = axis.high - axis.low
    size = 10.0 ** math.floor(math.log10(span / count)) if 0 < span < math.inf else 0.0
    if not size:
        return [axis.low]
    step = next(size * factor for factor in (1, 2, 5, 10) if span / (size * factor) <= count)
    first = math.ceil(axis.low / step)
    return [number * step for number in range(first, math.floor(axis.high / step) + 1)][: 2 * count]


def _short(value: float) -> str:
    return f"{value:.13g}".replace("-", "\u2212")
