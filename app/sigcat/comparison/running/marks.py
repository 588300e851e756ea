"""Duration of each call, and times of `Supervise`: the points of measurement of cores (docs/reference/adapter.md, §13), in a file.

A header defines them while cores are compiled. A production build has none of it: there the points are empty.
"""

import os
import struct
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.host.connections import Connections, Member
from sigcat.adapter.templates import rendered
from sigcat.comparison.recording import CallTime, Sent, Supervised
from sigcat.comparison.running.supervised import Moment, supervised_periods
from sigcat.errors import UsageError

NAME = "marks"
"""Name of the folder of marks in that of a run."""
FOLDER = "SIGCAT_MARKS"
"""The variable that names the folder of the files; without it, nothing is measured."""
_HEADER = "sigcat_marks.h"
_TEMPLATE = "comparison/running/sigcat_marks.h.j2"
_RECORD = struct.Struct("=QQQQQII")
_PREEMPTED = 1 << 31
_NO_CALL = 1 << 30
"""The number of `Supervise` in a record."""
_BITS = 32
_TEXTS = {False: "INACTIVE", True: "ACTIVE"}


class _Reaction(NamedTuple):
    """A safety reaction: its output, the number that means active, and its bit in a record."""

    name: str
    active: int
    bit: int


class _Function(NamedTuple):
    """A function, with the macro that its core calls at each point of measurement."""

    function: str
    macro: str
    reactions: Sequence[_Reaction]


class Marked(NamedTuple):
    """Content of the mark files of a run."""

    calls: tuple[CallTime, ...]
    reactions: Mapping[str, tuple[Sent, ...]]
    """Safety reactions by their interfaces, with every change of their state in the core."""
    supervised: tuple[Supervised, ...] = ()


def write_header(members: Iterable[Member], folder: Path) -> Path:
    """The header that a compiler includes before a core (`-include`)."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / _HEADER
    text = rendered(_TEMPLATE, folder=FOLDER, functions=[_function(member) for member in members])
    if not path.exists() or path.read_text("utf-8") != text:
        path.write_text(text, "utf-8")
    return path


def cmake_settings(members: Iterable[Member], folder: Path) -> Mapping[str, str]:
    """With which a project of CMake is measured."""
    included = f"-include {write_header(members, folder)}"
    return {"CMAKE_C_FLAGS": included, "CMAKE_CXX_FLAGS": included}


def _function(member: Member) -> "_Function":
    reactions = [
        _Reaction(each.named.name, each.active, 1 << bit) for bit, each in enumerate(member.plan.reactions[:_BITS])
    ]
    return _Function(member.name, Scope(member.plan).constant("MARK"), reactions)


@contextmanager
def measuring(folder: Path) -> Iterator[None]:
    """Cores in processes that have this process's environment write their times to a folder."""
    before = os.environ.get(FOLDER)
    os.environ[FOLDER] = str(folder)
    try:
        yield
    finally:
        os.environ.pop(FOLDER)
        if before is not None:
            os.environ[FOLDER] = before


def read_marks(connections: Connections, folder: Path, start: int, clock: int = 0) -> Marked:
    """Read what was written. The drive begins at `start`; time 0 of the drive is `clock` in the time of the platform.

    A record that was cut off, as when a process is killed, is left out.

    Raises UsageError for an unknown call: nodes that people wrote number their calls themselves.
    """
    calls: list[CallTime] = []
    reactions: dict[str, tuple[Sent, ...]] = {}
    supervised: list[Supervised] = []
    for index, member in enumerate(connections.members):
        processes = [[*_records(path)] for path in sorted(folder.glob(f"{member.name}.*"))]
        records = [record for process in processes for record in process]
        names = [step.interface for step in member.plan.steps]
        calls += [_call_time(member.name, names, record) for record in records if _number(record) != _NO_CALL]
        supervised += supervised_periods(member.plan, [[_moment(each) for each in process] for process in processes])
        columns = {each.field: each.name for each in connections.exits if each.member == index}
        reactions.update(_reactions(member, columns, records, start, clock))
    return Marked(tuple(calls), reactions, tuple(supervised))


def _records(path: Path) -> Iterator[tuple[int, ...]]:
    data = path.read_bytes()
    return _RECORD.iter_unpack(data[: len(data) // _RECORD.size * _RECORD.size])


def _number(record: tuple[int, ...]) -> int:
    """Return the number of the call."""
    return record[-2] & ~_PREEMPTED


def _moment(record: tuple[int, ...]) -> Moment:
    now, begins, *_, ends, _, _ = record
    number = _number(record)
    return Moment(0, now, now) if number == _NO_CALL else Moment(number, now, now + ends - begins)


def _call_time(function: str, names: Sequence[str], record: tuple[int, ...]) -> CallTime:
    now, begins, called, returned, ends, call, _ = record
    number, is_preempted = _number(record), bool(call & _PREEMPTED)
    if not 1 <= number <= len(names):
        raise UsageError(f"what was measured of {function} names its call {number}; it has calls 1 to {len(names)}")
    return CallTime(function, names[number - 1], now, ends - begins, returned - called, begins, is_preempted)


def _reactions(
    member: Member, columns: Mapping[str, str], records: Sequence[tuple[int, ...]], start: int, clock: int
) -> Iterator[tuple[str, tuple[Sent, ...]]]:
    for bit, each in enumerate(member.plan.reactions[:_BITS]):
        is_active = each.initial == each.active
        found = [(start, _TEXTS[is_active])]
        for now, *_, active in records:
            if bool(active & 1 << bit) != is_active:
                is_active = not is_active
                found.append((max(now - clock, start), _TEXTS[is_active]))
        yield columns[each.named.name], tuple(found)
