"""AUTOSAR adaptive: applications on the bench runtime, a process each, over SOME/IP in a separate network."""

import os
import shutil
from collections.abc import Mapping
from pathlib import Path

from sigcat.adapter.host.connections import Connections
from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.recording import Built, Recording
from sigcat.comparison.running import bench, marks
from sigcat.comparison.running.end_to_end import drive_start, read_end_to_end
from sigcat.comparison.running.processes import Outcome, Process, launched, own_network
from sigcat.comparison.running.recorded import begin_of, fresh_run, read_recorded, write_normalized
from sigcat.comparison.running.runner import Drive, Kill, Runner, Subject
from sigcat.comparison.running.slow_calls import durations
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.limits import DEFAULT_LIMITS

NAME = "autosar-adaptive"
_PORT = "40000"
"""At which the player waits for the components, in lock step."""
_BENCH = bench.Bench(
    NAME,
    ("bench/", "generated/", "player/"),
    "AUTOSAR adaptive: sigcat's bench runtime instead of a vendor's platform",
    {"CMAKE_UNITY_BUILD": "ON", "CMAKE_UNITY_BUILD_BATCH_SIZE": 100},
)


def _missing(environment: Mapping[str, str]) -> str | None:
    path = environment.get("PATH")
    if not shutil.which("cmake", path=path) or not (environment.get("CXX") or shutil.which("c++", path=path)):
        return "autosar-adaptive needs CMake and a C++ compiler: apt-get install cmake g++"
    if own_network() is None:
        return "autosar-adaptive needs a separate network: Linux that lets users make namespaces (`unshare -Urn true`)"
    return None


def _build(subject: Subject, folder: Path, tools: Toolchain) -> Built:
    del tools  # CMake finds its own, by the same variables
    return bench.build(_BENCH, subject, folder)


def _play(built: Built, subject: Subject, drive: Drive) -> Recording:
    run = fresh_run(built, drive)
    model = _model(built.folder)
    mode = {"BENCH_PLAYER": _PORT} if drive.mode == "lock step" else {"BENCH_STAMPS": "1"}
    slow = durations(drive, subject.prepared)
    environment = {**os.environ, **mode, **slow, marks.FOLDER: str(run / marks.NAME)}
    programs = built.folder / "build"
    processes = [
        Process(name, (str(programs / name / name),), environment, (programs / name / name,))
        for name in dict.fromkeys(each.executable for each in model.components)
    ]
    recorded = run / "recorded.csv"
    player = programs / "player/player"
    kills = [_kill(model, each) for each in drive.kills]
    normalized = write_normalized(drive.trace, subject.prepared, run / "normalized.tsv")
    command = (str(player), str(normalized), str(recorded), str(drive.end_ns / 1e9), *kills)
    outcome = launched(processes, Process("player", command, environment, (player,)), run, own_network() or ())
    return _recording(built, subject, drive, outcome, run)


def _recording(built: Built, subject: Subject, drive: Drive, outcome: Outcome, run: Path) -> Recording:
    prepared = subject.prepared
    times = run / "recorded.csv.times"
    begin = begin_of(drive.trace, prepared)
    marked = marks.read_marks(prepared.connections, run / marks.NAME, begin, drive_start(times))
    sent = read_recorded(run / "recorded.csv", prepared.columns)
    return Recording(
        NAME,
        drive.mode,
        built,
        {**sent, **marked.reactions},
        marked.calls,
        outcome.loads,
        last_words=outcome.last_words,
        play_s=outcome.seconds,
        silent=tuple(marked.reactions),
        end_to_end=read_end_to_end(times, drive.trace, prepared, marked.calls),
        fields=_fields(prepared.connections),
        supervised=marked.supervised,
    )


def _fields(connections: Connections) -> tuple[str, ...]:
    """Statuses of errors."""
    errors = {error.named.name for member in connections.members for error in member.plan.errors}
    return tuple(each.name for each in connections.exits if each.field in errors)


def _model(folder: Path) -> IntegrationModel:
    path = folder / "integration.json"
    return read_integration(path.read_bytes(), str(path), DEFAULT_LIMITS)


def _kill(model: IntegrationModel, kill: Kill) -> str:
    component = next(each for each in model.components if each.function == kill.function)
    return f"{component.executable}@{component.name}@{kill.time_ns}"


AUTOSAR_ADAPTIVE = Runner(NAME, "AUTOSAR adaptive", _missing, _build, _play, paper_platform="AUTOSAR")
