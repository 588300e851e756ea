"""Functions are run with a trace, in simulated time: built in a folder that goes away again, then run to the end."""

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.toolchain import Toolchain
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.runs.building.build import build
from sigcat.runs.building.memory import Memory, memory_of
from sigcat.runs.driver.tables import targets_of
from sigcat.runs.kept import Kept
from sigcat.runs.length import check_length
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.recorded import Recorded
from sigcat.runs.recording.shapes import Value, packing
from sigcat.runs.recording.trace_file import Trace, moments
from sigcat.runs.running.rows import InitFails, Row, Stored
from sigcat.runs.running.run import Command, Stopped, run
from sigcat.runs.running.written_input import Span, write_input
from sigcat.runs.stops import refusal

INPUT = "input"


class Settings(NamedTuple):
    """How a run goes."""

    duration: int | None = None
    """In ns, from the first row of the trace on; None: until its last row."""
    ignition_cycle: int = 1
    step_limit: float = 10.0
    """Seconds that a call may take."""
    kept: Mapping[Kept, Value] = {}
    """What the functions kept from before."""
    tells_memory: bool = False
    gone: Mapping[str, int] = {}
    """Functions that end without a word, by name, and when, in ns."""
    prints: Path | None = None
    """A file for what functions print; None: it goes where our errors go."""


class Simulated(NamedTuple):
    """What happened in a run."""

    rows: tuple[Recorded, ...]
    kept: Mapping[Kept, Value]
    """What the functions keep for the next ignition cycle."""
    findings: tuple[Finding, ...]
    stop: InputRefused | None
    """Why it did not come to its end."""
    end: int
    """When it was to end, in ns."""
    memory: tuple[Memory, ...] = ()
    """What the core of each function takes, if that was asked for."""


def simulate(prepared: Prepared, trace: Trace | None, settings: Settings, tools: Toolchain) -> Simulated:
    """Run the functions. Raises InputRefused if the trace cannot be used, or the code cannot be built."""
    with tempfile.TemporaryDirectory(prefix="sigcat-") as name:
        folder = Path(name)
        members = prepared.connections.members
        span = _write_input(prepared, trace, settings, folder / INPUT)
        start, end = _times(span, settings)
        check_length(members, start, end, trace, span.line if settings.duration is None else None)
        program = build(prepared.connections, prepared.numbers, folder, tools)
        memory = memory_of(members, folder, tools) if settings.tells_memory else ()
        command = Command(
            program, folder / INPUT, start, end, settings.ignition_cycle, settings.step_limit, settings.prints
        )
        return _run(prepared, command, trace)._replace(memory=memory)


def _write_input(prepared: Prepared, trace: Trace | None, settings: Settings, path: Path) -> Span:
    connections, numbers = prepared.connections, prepared.numbers
    rows = moments(trace) if trace else iter(())
    with path.open("wb") as file:
        return write_input(
            file, settings.kept, rows, targets_of(connections, numbers), connections, numbers, settings.gone
        )


def _times(span: Span, settings: Settings) -> tuple[int, int]:
    start = span.first or 0
    if settings.duration is not None:
        return start, start + settings.duration
    if span.last is None:
        raise UsageError("there is no row in the trace: say with --duration how long to run")
    return start, span.last


def _run(prepared: Prepared, command: Command, trace: Trace | None) -> Simulated:
    exits = [packing(each.shape) for each in prepared.connections.exits]
    kept = [packing(each.shape) for each in prepared.numbers.kept]
    rows: list[Recorded] = []
    left: dict[Kept, Value] = {}
    findings: list[Finding] = []
    stop = None
    try:
        for event in run(command, exits, kept):
            if isinstance(event, Row):
                rows.append(_recorded(event, prepared))
            elif isinstance(event, Stored):
                left[prepared.numbers.kept[event.kept]] = event.value
            elif isinstance(event, InitFails):
                findings.append(_init_fails(prepared, event.member))
    except Stopped as stopped:
        stop = refusal(stopped, prepared, trace, rows, command.step_limit)
    return Simulated(tuple(rows), left, tuple(findings), stop, command.end)


def _recorded(row: Row, prepared: Prepared) -> Recorded:
    exits = prepared.connections.exits
    call = prepared.numbers.calls[row.call] if row.call is not None else None
    values = tuple([(exits[number].names[0], value) for number, value in row.values])
    return Recorded(row.time, call.interface if call else "", values)


def _init_fails(prepared: Prepared, index: int) -> Finding:
    member = prepared.connections.members[index]
    message = f"Init of {member.name} has failed: none of its calls runs."
    pointer = member.plan.inits[0].pointer
    return member.function.finding(codes.INIT_FAILS, pointer, message, path=member.name)
