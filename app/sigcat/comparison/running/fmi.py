"""FMI: one FMU of the whole set in FMPy, with a communication step at each row of the drive and at each time of the schedule."""

import shutil
import time
from collections import defaultdict
from collections.abc import Iterator, Mapping
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path

from sigcat.adapter.host.shapes import Value
from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.recording import Built, Recording, Sent
from sigcat.comparison.running import marks
from sigcat.comparison.running.generated import generated
from sigcat.comparison.running.recorded import fresh_run, write_recorded
from sigcat.comparison.running.runner import Drive, Runner, Subject
from sigcat.errors import UsageError
from sigcat.platforms.table import PLATFORMS
from sigcat.players import cmake
from sigcat.players.commands import write
from sigcat.players.fmu import Limits, Step, read_fmu, stepped
from sigcat.players.fmu_interfaces import Interfaces, interfaces_of
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.cells import cell_of
from sigcat.runs.recording.trace_file import Moment, moments, open_trace

NAME = "fmi"
_NOTE = "FMI: FMPy as importer; outputs are compared at its communication points"


def _missing(environment: Mapping[str, str]) -> str | None:
    path = environment.get("PATH")
    if not shutil.which("cmake", path=path) or not (environment.get("CC") or shutil.which("cc", path=path)):
        return "fmi needs CMake and a C compiler: apt-get install cmake gcc"
    return None if find_spec("fmpy") else "fmi needs FMPy: pip install 'sigcat[fmi]'"


def _build(subject: Subject, folder: Path, tools: Toolchain) -> Built:
    del tools  # CMake finds its own, by the same variables
    settings = PLATFORMS[NAME].settings().model_validate({"fmus": "set"})
    deployment = subject.deployment.model_copy(update={NAME: settings})
    made = generated(subject._replace(deployment=deployment), NAME)
    write(made.files, folder)
    begin = time.monotonic()
    measured = marks.cmake_settings(subject.prepared.connections.members, folder / "marks")
    cmake.build(folder, folder / "build", {**subject.code_settings, **measured})
    return Built(NAME, folder, made.files, made.seconds, time.monotonic() - begin, (_NOTE,))


def _play(built: Built, subject: Subject, drive: Drive) -> Recording:
    prepared, run = subject.prepared, fresh_run(built, drive)
    (file,) = (built.folder / "build").glob("*.fmu")
    rows = list(moments(open_trace(drive.trace, prepared.known_in_drive)))
    begin = rows[0].time if rows else 0
    points = _points(rows, prepared, begin, drive.end_ns)
    interfaces = interfaces_of(prepared.connections)
    started = time.monotonic()
    sent: defaultdict[str, list[Sent]] = defaultdict(list)
    words, known = "", dict[str, Value]()
    steps = stepped(read_fmu(file), _steps(rows, points, interfaces), Limits(drive.step_limit_s))
    with marks.measuring(run / marks.NAME):
        try:
            for row in steps:
                known.update(row.values)
                for name, value, shape in interfaces.of_variables(known, (each for each, _ in row.values)):
                    sent[name].append((begin + row.time, cell_of(value, shape)))
        except UsageError as error:
            words = str(error)
    values = {name: tuple(each) for name, each in sent.items()}
    write_recorded(values, run / "recorded.csv")
    marked = marks.read_marks(prepared.connections, run / marks.NAME, 0)
    return Recording(
        NAME, drive.mode, built, values, marked.calls, last_words=words, play_s=time.monotonic() - started,
        supervised=marked.supervised, points=tuple(points[1:]),
    )  # fmt: skip


def _points(rows: list[Moment], prepared: Prepared, begin: int, end: int) -> list[int]:
    """Times at which a step begins, in ns: a value that is sent at one of them is seen at the next. The last one only ends a step."""
    calls = [call for member in prepared.connections.members for call in member.plan.steps]
    due = {each for call in calls if call.cycle for each in range(begin + call.offset, end + 1, call.cycle)}
    received = {row.time for row in rows if row.time <= end}
    return [*sorted({begin, *due, *received}), end + 1]


def _steps(rows: list[Moment], points: list[int], interfaces: Interfaces) -> Iterator[Step]:
    values: defaultdict[int, list[Moment]] = defaultdict(list)
    for row in rows:
        values[row.time].append(row)
    for point, following in pairwise(points):
        given = [each for row in values[point] for each in row.values]
        yield Step(point - points[0], following - point, interfaces.as_variables(given))


FMI = Runner(NAME, "FMI", _missing, _build, _play, is_sampled=True)
