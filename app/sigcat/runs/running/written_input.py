"""The input of the driver: a trace, each value as the bytes of where it goes."""

import struct
from collections.abc import Iterable, Mapping, Sequence
from typing import BinaryIO, NamedTuple

from sigcat.adapter.host.connections import Connections
from sigcat.adapter.host.kept import Kept
from sigcat.adapter.host.numbering import Numbers
from sigcat.adapter.host.shapes import Value
from sigcat.runs.driver.tables import Target
from sigcat.runs.recording.trace_file import Moment

_ENTRY = struct.Struct("=I")
_TIME = struct.Struct("=IQ")
NO_ENTRY = 2**32 - 1
"""Number before the time of the entries that follow."""
_YES = b"\x01"


class Span(NamedTuple):
    """Times of the first and the last row, in ns; None without rows."""

    first: int | None = None
    last: int | None = None
    line: int = 0
    """Line of the last row."""


def write_kept(file: BinaryIO, kept: Mapping[Kept, Value], targets: Sequence[Target], numbers: Numbers) -> None:
    """Write what is kept from before."""
    stored = [(number, target) for number, target in enumerate(targets) if target.kind == "STORED"]
    for (number, target), each in zip(stored, numbers.kept, strict=True):
        if each in kept:
            file.write(_ENTRY.pack(number) + target.packing.pack(kept[each]))


def write_rows(
    file: BinaryIO, rows: Iterable[Moment], targets: Sequence[Target], connections: Connections, numbers: Numbers,
    gone: Mapping[str, int],
) -> Span:  # fmt: skip
    """Write a trace. Raises InputRefused with its findings.

    `gone` has the time, by function name, after which nothing of it is called.
    """
    indexes = {member.name: index for index, member in enumerate(connections.members)}
    first = next(number for number, target in enumerate(targets) if target.kind == "GONE")
    ends = sorted((time, first + indexes[name]) for name, time in gone.items())
    return _write_rows(file, rows, targets_by_column(connections, numbers), targets, ends)


def _write_rows(
    file: BinaryIO, rows: Iterable[Moment], by_column: Mapping[str, Sequence[int]], targets: Sequence[Target],
    ends: Sequence[tuple[int, int]],
) -> Span:  # fmt: skip
    span, left = Span(), list(ends)
    for row in rows:
        time = row.time
        while left and left[0][0] <= time:
            file.write(_end(*left.pop(0)))
        span = Span(time if span.first is None else span.first, time, row.line)
        file.write(moment_bytes(row, by_column, targets))
    file.writelines(_end(*end) for end in left)
    return span


def _end(time: int, number: int) -> bytes:
    return _TIME.pack(NO_ENTRY, time) + _ENTRY.pack(number) + _YES


def moment_bytes(row: Moment, by_column: Mapping[str, Sequence[int]], targets: Sequence[Target]) -> bytes:
    """The records of a row."""
    parts = [_TIME.pack(NO_ENTRY, row.time)]
    for column, value in row.values:
        numbers = by_column[column]
        data = targets[numbers[0]].packing.pack(value)
        parts += [_ENTRY.pack(number) + data for number in numbers]
    return b"".join(parts)


def targets_by_column(connections: Connections, numbers: Numbers) -> Mapping[str, Sequence[int]]:
    """The targets that get the values of a column, by its name."""
    found: dict[str, list[int]] = {}
    for number, entry in enumerate(connections.entries):
        for name in entry.names:
            found.setdefault(name, []).append(number)
    for number, call in enumerate(numbers.calls):
        if call:
            found[call.interface] = [len(connections.entries) + number]
    return found
