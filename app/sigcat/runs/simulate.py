"""Build functions in a temporary folder, and run them with a trace in simulated time."""

import ctypes
from collections.abc import Callable, Generator, Mapping
from contextlib import closing
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.host.kept import Kept
from sigcat.adapter.host.shapes import Value, packing
from sigcat.adapter.toolchain import Toolchain
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.runs.building.build import build
from sigcat.runs.building.coverage import FLAGS, report_coverage
from sigcat.runs.building.library import convert_library
from sigcat.runs.building.memory import Memory, memory_of
from sigcat.runs.driver.tables import targets_of
from sigcat.runs.length import check_length, cyclic_calls
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.outside import OutsideValues
from sigcat.runs.recording.recorded import Recorded
from sigcat.runs.recording.trace_file import Trace
from sigcat.runs.recording.traces import moments
from sigcat.runs.running.converted_input import convert_csv, convert_mcap
from sigcat.runs.running.fast_scan import fast_scanner
from sigcat.runs.running.process import Limits
from sigcat.runs.running.rows import Block, InitFails, Layout, Progress, Row, Stored, decoded, scanner
from sigcat.runs.running.run import Command, Stopped, run
from sigcat.runs.running.sandbox import sandbox
from sigcat.runs.running.written_input import Span, targets_by_column, write_kept, write_rows
from sigcat.runs.stops import refusal
from sigcat.temporary_files import temporary_folder

NO_INPUTS = "the run has no inputs: name a trace with --trace FILE, or run without inputs for --duration SECONDS"
INPUT, RESULTS = "input", "results"
MIB = 1 << 20
LONG_BYTES, LONG_CALLS = MIB, 50_000
"""From a trace of so many bytes, or so many calls, on, the library in C converts it."""


class Settings(NamedTuple):
    """Settings of a run."""

    duration: int | None = None
    """In ns, from the first row of the trace on; None: until its last row."""
    ignition_cycle: int = 1
    step_limit: float = 10.0
    """Seconds that a call may take."""
    kept: Mapping[Kept, Value] = {}
    """Values that the functions kept from the run before."""
    tells_memory: bool = False
    gone: Mapping[str, int] = {}
    """Functions that end silently, by name, and when, in ns."""
    prints: Path | None = None
    """A file for what functions print; None: it goes where our errors go."""
    memory_limit: int = 2048 * MIB
    """Bytes that the process may allocate."""
    output_limit: int = 1024 * MIB
    """Bytes that the functions may print, and of a file that they write."""
    echoes: bool = False
    """Whether blocks have what is received, too."""
    is_sandboxed: bool = False
    coverage: Path | None = None
    """A folder for reports about the coverage of the code."""


class Simulated(NamedTuple):
    """Result of a run."""

    kept: Mapping[Kept, Value]
    """Values that the functions keep for the next ignition cycle."""
    findings: tuple[Finding, ...]
    stop: InputRefused | None
    """Why it did not come to its end."""
    memory: tuple[Memory, ...] = ()
    """Memory of each function's core, if it was asked for."""


Take = Callable[[Block, ctypes.CDLL | None], None]
"""A function that takes rows as they come, and the library that converts them where there is one."""

Blocks = Generator[tuple[Block, ctypes.CDLL | None], None, Simulated]
"""Rows as they come, then what happened in the run."""


class Collected:
    """Takes rows, and keeps all of them: memory grows with the length of the run."""

    def __init__(self, prepared: Prepared) -> None:
        self.rows: list[Recorded] = []
        self._prepared, self._layout = prepared, layout_of(prepared)

    def __call__(self, block: Block, library: ctypes.CDLL | None) -> None:
        """Take a block."""
        del library
        found = decoded(block, self._layout)
        self.rows += [recorded(row, self._prepared) for row in found if isinstance(row, Row)]


def layout_of(prepared: Prepared) -> Layout:
    """Values of records of the driver."""
    connections = prepared.connections
    return Layout(*([packing(each.shape) for each in listed]
                    for listed in (connections.exits, connections.entries, prepared.numbers.kept)))  # fmt: skip


def recorded(row: Row, prepared: Prepared) -> Recorded:
    """A row with names."""
    exits = prepared.connections.exits
    call = prepared.numbers.calls[row.call] if row.call is not None else None
    values = tuple([(exits[number].names[0], value) for number, value in row.values])
    return Recorded(row.time, call.interface if call else "", values)


def simulate(prepared: Prepared, trace: Trace | None, settings: Settings, tools: Toolchain, take: Take) -> Simulated:
    """Run the functions; rows are taken as they come.

    Raises InputRefused if the trace cannot be used, or the code cannot be built: then no row was taken.
    """
    with closing(simulated_blocks(prepared, trace, settings, tools)) as blocks:
        while True:
            try:
                block, library = next(blocks)
            except StopIteration as end:
                done: Simulated = end.value
                return done
            take(block, library)


def simulated_blocks(prepared: Prepared, trace: Trace | None, settings: Settings, tools: Toolchain) -> Blocks:
    """Run the functions, and yield blocks of rows as they come. Closing it ends the run. Raises as `simulate` does."""
    with temporary_folder("sigcat-simulate-") as name:
        folder = Path(name)
        members = prepared.connections.members
        library = convert_library(folder, tools) if _is_long(prepared, trace, settings.duration) else None
        span, notes = _write_input(prepared, trace, settings, folder / INPUT, library)
        start, end = _times(span, settings)
        check_length(members, start, end, trace, span.line if settings.duration is None else None)
        flags = FLAGS if settings.coverage else ()
        program, warned = build(prepared.connections, prepared.numbers, folder, tools, flags)
        memory = memory_of(members, folder, tools) if settings.tells_memory else ()
        limits = Limits(settings.step_limit, settings.output_limit)
        command = Command(
            (*_sandbox(settings, folder), str(program)), folder / INPUT, folder / RESULTS, start, end,
            settings.ignition_cycle, settings.echoes, settings.memory_limit, limits, settings.prints, settings.is_sandboxed,
        )  # fmt: skip
        done = yield from _run(prepared, command, trace, library)
        if settings.coverage is not None and done.stop is None:
            report_coverage(members, folder, settings.coverage, tools)
        return done._replace(memory=memory, findings=(*notes, *warned, *done.findings))


def _sandbox(settings: Settings, folder: Path) -> tuple[str, ...]:
    """Words that start the program: none, or a sandbox that writes to nothing but the results."""
    if not settings.is_sandboxed:
        return ()
    (folder / RESULTS).touch()
    return sandbox((), (folder,)) if settings.coverage else sandbox((folder,), (folder / RESULTS,))


def _write_input(
    prepared: Prepared, trace: Trace | None, settings: Settings, path: Path, library: ctypes.CDLL | None
) -> tuple[Span, tuple[Finding, ...]]:
    connections, numbers = prepared.connections, prepared.numbers
    targets, by_column = targets_of(connections, numbers), targets_by_column(connections, numbers)
    outside, notes = OutsideValues(connections.ranges), tuple[Finding, ...]()
    with path.open("wb") as file:
        write_kept(file, settings.kept, targets, numbers)
        if trace is not None and trace.known is not None:
            span, notes = convert_mcap(file, trace, by_column, targets, library, outside)
        elif trace is not None and library is not None and not settings.gone:
            span = convert_csv(file, trace, by_column, targets, library, outside)
        else:
            rows = outside.looked_at(moments(trace)) if trace else iter(())
            span = write_rows(file, rows, targets, connections, numbers, settings.gone)
    return span, (*notes, *(outside.findings(trace) if trace else ()))


def _is_long(prepared: Prepared, trace: Trace | None, duration: int | None) -> bool:
    """Whether a run takes longer than it takes to compile what makes it shorter."""
    calls = cyclic_calls(prepared.connections.members, duration or 0)
    return calls > LONG_CALLS or (trace is not None and trace.file.stat().st_size > LONG_BYTES)


def _times(span: Span, settings: Settings) -> tuple[int, int]:
    start = span.first or 0
    if settings.duration is not None:
        return start, start + settings.duration
    if span.last is None:
        raise UsageError(NO_INPUTS)
    return start, span.last


def _run(prepared: Prepared, command: Command, trace: Trace | None, library: ctypes.CDLL | None) -> Blocks:
    layout, progress = layout_of(prepared), Progress()
    scan = fast_scanner(layout, len(prepared.numbers.calls), library) if library else scanner(layout)
    left: dict[Kept, Value] = {}
    findings: list[Finding] = []
    stop = None
    try:
        for event in run(command, layout, scan, progress):
            if isinstance(event, Block):
                yield event, library
            elif isinstance(event, Stored):
                left[prepared.numbers.kept[event.kept]] = event.value
            elif isinstance(event, InitFails):
                findings.append(_init_fails(prepared, event.member))
    except Stopped as stopped:
        sent = {number: layout.exits[number].unpack(data) for number, data in progress.sent().items()}
        stop = refusal(stopped, prepared, trace, sent, command.limits)
    return Simulated(left, tuple(findings), stop)


def _init_fails(prepared: Prepared, index: int) -> Finding:
    member = prepared.connections.members[index]
    message = f"Init of {member.name} has failed: none of its calls runs."
    pointer = member.plan.inits[0].pointer
    return member.function.finding(codes.INIT_FAILS, pointer, message, path=member.name)
