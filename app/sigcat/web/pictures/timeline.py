"""The schedule of functions on a time line: when each cyclic call begins, and how long it may take."""

from collections.abc import Iterable
from fractions import Fraction
from math import gcd, lcm
from typing import NamedTuple

from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import calls_of
from sigcat.web.template_filters import number

LEFT, WIDTH = 230, 640
_ROW = 34
_TOP = 34
_MOST_MARKS = 50
"""Multiple of the shortest period; a longer pattern is cut off."""
_LONGEST_PERIOD = 10**9
"""In ms; a call that is rarer than that is not drawn."""


class Mark(NamedTuple):
    """One call on the line, in pixels. A width of 0 is a call of which no longest duration is known."""

    x: float
    width: float


class Lane(NamedTuple):
    """All calls of one runnable."""

    y: int
    name: str
    period: str
    priority: str
    marks: tuple[Mark, ...]
    title: str


class TimeLine(NamedTuple):
    """Positions of all elements."""

    lanes: tuple[Lane, ...]
    ticks: tuple[tuple[float, str], ...]
    height: int
    horizon: str
    is_whole: bool
    """Whether the pattern repeats after what is shown."""
    others: tuple[tuple[str, str], ...]
    """Calls that are not cyclic: (name, when)."""


class _Cyclic(NamedTuple):
    call: Runnable
    period: float
    offset: float


def time_line(functions: Iterable[FunctionJson]) -> TimeLine | None:
    """The time line of functions; None if nothing is cyclic."""
    calls = [call for function in functions for call in calls_of(function)]
    cyclic = [
        _Cyclic(call, float(call.cycle_time), milliseconds(call.execution_offset) or 0.0)
        for call in calls
        if call.cycle_time and 0 < call.cycle_time <= _LONGEST_PERIOD
    ]
    if not cyclic:
        return None
    cyclic.sort(key=lambda each: (each.period, each.call.name))
    whole = _common_period([each.period for each in cyclic])
    longest = max(each.period + each.offset for each in cyclic)
    horizon = min(whole, max(_MOST_MARKS * cyclic[0].period, longest))
    lanes = tuple(_lane(index, each, horizon) for index, each in enumerate(cyclic))
    others = tuple((call.name, call.run_type) for call in calls if not call.cycle_time)
    height = _TOP + _ROW * len(lanes) + 30
    return TimeLine(lanes, _ticks(horizon), height, f"{number(_tidy(horizon))}\u00a0ms", whole <= horizon, others)


def _common_period(periods: list[float]) -> float:
    """After so many ms the pattern repeats."""
    exact = [Fraction(period).limit_denominator(1000) for period in periods]
    return lcm(*(each.numerator for each in exact)) / gcd(*(each.denominator for each in exact))


def _lane(index: int, each: _Cyclic, horizon: float) -> Lane:
    call = each.call
    longest = call.watchdog.deadline.max if call.watchdog and call.watchdog.deadline else 0
    marks: list[Mark] = []
    start = each.offset
    while start < horizon and len(marks) < 1000:
        width = min(longest, horizon - start) / horizon * WIDTH
        marks.append(Mark(round(LEFT + start / horizon * WIDTH, 2), round(width, 2)))
        start += each.period
    title = f"{call.name}: every {each.period:g} ms from {each.offset:g} ms on"
    title += f", at most {longest:g} ms" if longest else ""
    period = f"{number(_tidy(each.period))}\u00a0ms"
    return Lane(_TOP + index * _ROW + _ROW // 2, call.name, period, call.priority, tuple(marks), title)


def _ticks(horizon: float) -> tuple[tuple[float, str], ...]:
    step = next(s * 10**e for e in range(-3, 13) for s in (1, 2, 5) if horizon / (s * 10**e) <= 10)
    count = int(horizon / step + 1e-9)
    return tuple((round(LEFT + i * step / horizon * WIDTH, 2), number(_tidy(i * step))) for i in range(count + 1))


def _tidy(value: float) -> float | int:
    return int(value) if value == int(value) else round(value, 3)
