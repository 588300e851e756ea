"""What was received and sent, value by value, in order of time."""

from collections.abc import Iterable, Iterator
from heapq import merge
from typing import NamedTuple

from sigcat.runs.recording.recorded import Recorded
from sigcat.runs.recording.shapes import Value
from sigcat.runs.recording.trace_file import Moment


class Sample(NamedTuple):
    """A value, when it came or went."""

    time: int
    name: str
    value: Value


def samples(received: Iterable[Moment], sent: Iterable[Recorded]) -> Iterator[Sample]:
    """The values of a trace and those of a run; at the same time, what came is before what went."""
    return merge(_samples(received), _samples(sent), key=lambda each: each.time)


def _samples(rows: Iterable[Moment | Recorded]) -> Iterator[Sample]:
    return (Sample(row.time, name, value) for row in rows for name, value in row.values)
