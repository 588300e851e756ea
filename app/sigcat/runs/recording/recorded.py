"""A row of a recording: when, by which call, and what was sent."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.adapter.host.shapes import Value


class Recorded(NamedTuple):
    """Values that were sent at a time."""

    time: int
    """In ns."""
    call: str
    """The call that ended then; empty if something was sent without one, as by a supervision."""
    values: tuple[tuple[str, Value], ...]
    """By the names of columns. A queue may have sent several."""


def split(row: Recorded) -> Iterator[Recorded]:
    """Rows that have each column once: earlier values of a queue are in rows before that of the call."""
    last = {name: index for index, (name, _) in enumerate(row.values)}
    for index, value in enumerate(row.values):
        if index != last[value[0]]:
            yield Recorded(row.time, "", (value,))
    yield row._replace(values=tuple(row.values[index] for index in sorted(last.values())))
