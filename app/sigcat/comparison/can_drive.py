"""A drive that was logged on CAN: the gateway makes the trace of it that is played, and how long each frame takes is measured."""

import time
from array import array
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.gateway.doubts import doubts
from sigcat.gateway.frames import Frame, Passed
from sigcat.gateway.logs.read import read_log
from sigcat.gateway.prepare import Prepared, prepare
from sigcat.gateway.trace import Row, added_trace, joined, lines_of, merged, rows_of
from sigcat.gateway.translation import Translation

_MOST_TIMES = 1_000_000
"""Frames that are measured: what is kept of a log does not grow with it."""


class Carried(NamedTuple):
    """Result of reading a log."""

    trace: Path
    translation_ns: Sequence[int]
    """Time for each frame: from reading it to writing its row."""
    findings: tuple[Finding, ...]
    counts: tuple[str, ...]
    """Counts of frames and values, as lines."""


def carry(log: Path, databases: Sequence[Path], catalogue: Catalogue, added: Path | None, folder: Path) -> Carried:
    """Write the trace of a log, with the columns of another one that nothing maps. Raises UsageError or InputRefused."""
    if not databases:
        raise UsageError(f"{log} is a log of CAN: name its database with --dbc FILE")
    prepared = prepare(catalogue, databases)
    found: list[Finding] = []
    times = array("q")
    translation = Translation(prepared.database, prepared.mapped, is_from_zero=True)
    trace = folder / f"{log.name}.csv"
    rows = rows_of(translation.moments(_timed(read_log(log, found), times), str(log)))
    _write(rows, prepared, added, trace)
    told = (*prepared.findings, *found, *translation.findings, *doubts(translation, str(log), found))
    if not translation.counts.sent:
        raise InputRefused(
            f"{log} has no value of a signal that is mapped: {'; '.join(translation.counts.lines())}", told
        )
    return Carried(trace, times, told, tuple(f"{log}: {line}" for line in translation.counts.lines()))


def _timed(frames: Iterable[Frame | Passed], times: "array[int]") -> Iterator[Frame | Passed]:
    """The same frames. Whoever asks for the next one is done with the one before."""
    for frame in frames:
        begin = time.perf_counter_ns()
        yield frame
        if len(times) < _MOST_TIMES:
            times.append(time.perf_counter_ns() - begin)


def _write(rows: Iterator[Row], prepared: Prepared, added: Path | None, trace: Path) -> None:
    columns = tuple(each.name for each in prepared.mapped)
    if added is not None:
        others = added_trace(added, prepared.mapped)
        rows, columns = merged(rows, others, len(columns)), (*columns, *others.columns)
    with trace.open("w", encoding="utf-8", newline="") as file:
        file.writelines(lines_of(joined(rows), columns))
