"""A recording: when which value came, written as CSV."""

import csv
import io
from collections.abc import Iterable, Sequence
from typing import NamedTuple

NANOSECONDS = 1_000_000_000
MILLISECOND = 1_000_000


class Message(NamedTuple):
    """A value that came."""

    time: int
    """In nanoseconds."""
    column: str
    text: str
    """The value, as text of a cell."""


class Gap(NamedTuple):
    """A time during which a signal is missing, or has a wrong value."""

    column: str
    begin: float
    """In seconds."""
    end: float
    text: str | None = None
    """The wrong value; None: nothing comes."""


def damaged(messages: Iterable[Message], gaps: Sequence[Gap]) -> Iterable[Message]:
    """The messages as they come with these gaps."""
    for message in messages:
        gap = next((gap for gap in gaps if gap.column == message.column and is_within(message.time, gap)), None)
        if gap is None:
            yield message
        elif gap.text is not None:
            yield message._replace(text=gap.text)


def is_within(time: int, gap: Gap) -> bool:
    return gap.begin * NANOSECONDS <= time < gap.end * NANOSECONDS


def write(columns: Sequence[str], messages: Iterable[Message]) -> str:
    """The messages by time. Those of one time share a row; a cell of which nothing came is empty."""
    rows: dict[int, dict[str, str]] = {}
    for message in messages:
        rows.setdefault(message.time, {})[message.column] = message.text
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(["time", *columns])
    for time, row in sorted(rows.items()):
        writer.writerow([seconds(time), *(row.get(column, "") for column in columns)])
    return file.getvalue()


def seconds(time: int) -> str:
    """With nine decimals."""
    return f"{time // NANOSECONDS}.{time % NANOSECONDS:09d}"


def number(value: float, decimals: int) -> str:
    """As short as it goes; never a negative zero."""
    return f"{round(value, decimals) + 0.0:.{decimals}f}".rstrip("0").rstrip(".")
