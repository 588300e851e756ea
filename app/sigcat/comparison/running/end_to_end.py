"""From a row of the drive to the values that depend on it: what a player has timed, beside what cores have marked.

Both have the clock of the machine. A call takes what has come before it begins: of a value that comes after the call's end, the
newest row that was sent before its begin, and that has something for its function, is where it began.
"""

import csv
from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from sigcat.adapter.host.connections import Connections
from sigcat.comparison.recording import CallTime
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.trace_file import moments, open_trace

_COLUMNS = 3


def read_end_to_end(
    path: Path, trace: Path, prepared: Prepared, calls: Sequence[CallTime]
) -> Mapping[str, tuple[int, ...]]:
    """By function, in ns; nothing of a run that was not timed."""
    if not path.exists():
        return {}
    sent, heard = _timed(path)
    given = _times_of_inputs(trace, prepared, max(sent, default=-1))
    return {
        member.name: tuple(
            _ages(
                [sent[row] for row in given[member.name] if row in sent],
                sorted(at for name in _signals(prepared.connections, index) for at in heard.get(name, ())),
                [each for each in calls if each.function == member.name],
            )
        )
        for index, member in enumerate(prepared.connections.members)
    }


def drive_start(path: Path) -> int:
    """Time of the machine's clock at time 0 of the drive, in ns; 0 of a run that was not timed, as in lock step."""
    sent = _timed(path)[0] if path.exists() else {}
    return min((at - row for row, at in sent.items()), default=0)


def _timed(path: Path) -> tuple[Mapping[int, int], Mapping[str, Sequence[int]]]:
    """When each row was sent, and when values came, by name. A last line that was cut off is left out."""
    sent: dict[int, int] = {}
    heard: defaultdict[str, list[int]] = defaultdict(list)
    with path.open(newline="", encoding="utf-8", errors="replace") as file:
        for line in csv.reader(file):
            if len(line) != _COLUMNS or not line[0].isdigit():
                continue
            at, name, row = line
            if name:
                heard[name].append(int(at))
            elif row.isdigit():
                sent[int(row)] = int(at)
    return sent, heard


def _times_of_inputs(trace: Path, prepared: Prepared, last: int) -> Mapping[str, Sequence[int]]:
    """Times of the rows that have something for a function, by its name."""
    members = prepared.connections.members
    takes = {
        member.name: {name for entry in prepared.connections.entries if entry.member == index for name in entry.names}
        for index, member in enumerate(members)
    }
    found: dict[str, list[int]] = {member.name: [] for member in members}
    for row in moments(open_trace(trace, prepared.known_in_drive)):
        if row.time > last:
            break
        names = {name for name, _ in row.values}
        for function, wanted in takes.items():
            if not wanted.isdisjoint(names):
                found[function].append(row.time)
    return found


def _signals(connections: Connections, member: int) -> Iterator[str]:
    """Names of values that a function's calls send, without statuses: those are sent when they change."""
    return (each.name for each in connections.exits if each.member == member and each.kind == "signal")


def _ages(sent: Sequence[int], heard: Sequence[int], calls: Sequence[CallTime]) -> Iterator[int]:
    """Yield the age of each received value since its row was sent. All are in order of time, by the machine's clock."""
    ended = sorted(calls, key=lambda each: each.end_ns)
    ends = [each.end_ns for each in ended]
    for at in heard:
        index = bisect_right(ends, at) - 1
        if index < 0:
            continue
        row = bisect_left(sent, ended[index].begin_ns) - 1
        if row >= 0:
            yield at - sent[row]
