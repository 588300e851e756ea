"""The simulation as a platform: the reference that all others are compared with."""

import time
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

from sigcat.adapter.toolchain import Toolchain, toolchain
from sigcat.comparison.recording import Built, Recording, Sent
from sigcat.comparison.running import marks
from sigcat.comparison.running.processes import last_lines
from sigcat.comparison.running.recorded import begin_of, fresh_run, write_recorded
from sigcat.comparison.running.runner import Drive, Runner, Subject
from sigcat.errors import InputRefused, UsageError
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.cells import cell_of
from sigcat.runs.recording.recorded import Recorded
from sigcat.runs.recording.trace_file import open_trace
from sigcat.runs.simulate import Collected, Settings, simulate

NAME = "simulate"


def _missing(environment: Mapping[str, str]) -> str | None:
    try:
        toolchain(environment)
    except UsageError as error:
        return str(error)
    return None


def _build(subject: Subject, folder: Path, tools: Toolchain) -> Built:
    del subject, tools  # built where it is played: that is a second
    folder.mkdir(parents=True, exist_ok=True)
    return Built(NAME, folder, (), 0.0, 0.0)


def _play(built: Built, subject: Subject, drive: Drive) -> Recording:
    prepared = subject.prepared
    trace = open_trace(drive.trace, prepared.known_in_drive)
    begin = time.monotonic()
    gone = {each.function: each.time_ns for each in drive.kills}
    run = fresh_run(built, drive)
    prints = run / f"{NAME}.txt"
    duration = max(drive.end_ns - begin_of(drive.trace, prepared), 0)
    settings = Settings(duration, step_limit=drive.step_limit_s, gone=gone, prints=prints)
    collected = Collected(prepared)
    with marks.measuring(run / marks.NAME):
        simulated = simulate(prepared, trace, settings, _with_marks(toolchain(), prepared, run), collected)
    marked = marks.read_marks(prepared.connections, run / marks.NAME, 0)
    sent = sent_by_name(collected.rows, prepared)
    write_recorded(sent, run / "recorded.csv")
    return Recording(
        NAME,
        drive.mode,
        built,
        sent,
        marked.calls,
        last_words=_last_words(simulated.stop, prints),
        play_s=time.monotonic() - begin,
        supervised=marked.supervised,
    )


def _last_words(stop: InputRefused | None, prints: Path) -> str:
    """Whether a call crashed or hangs, what it had received, and what functions had printed last."""
    return " ".join([*(each.message for each in stop.findings), str(stop), last_lines(prints)]).strip() if stop else ""


def _with_marks(tools: Toolchain, prepared: Prepared, folder: Path) -> Toolchain:
    """Compilers that put the points of measurement into cores, and nothing else."""
    flags = ("-include", str(marks.write_header(prepared.connections.members, folder)))
    return Toolchain((*tools.c, *flags), (*tools.cpp, *flags) if tools.cpp else ())


def sent_by_name(rows: Iterable[Recorded], prepared: Prepared) -> Mapping[str, tuple[Sent, ...]]:
    """Return sent values as text, by name."""
    found: defaultdict[str, list[Sent]] = defaultdict(list)
    columns = prepared.columns
    for row in rows:
        for name, value in row.values:
            found[name].append((row.time, cell_of(value, columns[name])))
    return {name: tuple(values) for name, values in found.items()}


SIMULATION = Runner(NAME, "Simulation", _missing, _build, _play)
