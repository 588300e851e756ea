"""Times between calls of `Supervise`, beside the longest period that the core allows (docs/reference/adapter.md, §10)."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from sigcat.adapter.core.plan.call import Call
from sigcat.adapter.core.plan.core_plan import CorePlan
from sigcat.comparison.recording import Supervised


class Moment(NamedTuple):
    """A call of `Supervise` (number 0), or a call of the function from its begin to its end, in ns of the platform's time."""

    number: int
    begin: int
    end: int


def supervised_periods(plan: CorePlan, processes: Iterable[Sequence[Moment]]) -> Iterator[Supervised]:
    """Return the times between calls of `Supervise` of a function, and those within its calls with a deadline.

    `NextTime` is not later than the next release, so the shortest cycle is the longest period while nothing runs.
    """
    if not any(call.alive or call.deadline for call in plan.steps):
        return
    started = [process for process in processes if process]
    cycles = [call.cycle for call in plan.steps if call.cycle]
    if cycles:
        gaps = [gap for process in started for gap in _gaps(_supervised(process), process[0].begin, process[-1].begin)]
        yield Supervised(plan.function, "", min(cycles), tuple(gaps))
    for number, call in enumerate(plan.steps, 1):
        if call.deadline:
            within = [gap for process in started for gap in _within(process, number, call)]
            yield Supervised(plan.function, call.interface, call.deadline.most, tuple(within))


def _supervised(process: Sequence[Moment]) -> list[int]:
    return sorted(each.begin for each in process if not each.number)


def _within(process: Sequence[Moment], number: int, call: Call) -> Iterator[int]:
    """Return the times between calls of `Supervise` in calls that took longer than their deadline."""
    times = _supervised(process)
    for each in process:
        if each.number == number and call.deadline and each.end - each.begin > call.deadline.most:
            yield from _gaps([time for time in times if each.begin < time < each.end], each.begin, each.end)


def _gaps(times: Sequence[int], begin: int, end: int) -> Iterator[int]:
    return (after - before for before, after in pairwise((begin, *times, end)))
