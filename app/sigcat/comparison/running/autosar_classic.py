"""AUTOSAR Classic: software components on the test RTE, in one process that is given the time."""

import os
import shutil
from collections.abc import Mapping
from pathlib import Path

from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.recording import Built, Recording
from sigcat.comparison.running import bench, marks
from sigcat.comparison.running.processes import Process, launched
from sigcat.comparison.running.recorded import begin_of, fresh_run, read_recorded, write_normalized
from sigcat.comparison.running.runner import Drive, Runner, Subject
from sigcat.comparison.running.slow_calls import durations

NAME = "autosar-classic"
_BENCH = bench.Bench(
    NAME,
    ("test_rte/", "contract/"),
    "AUTOSAR Classic: sigcat's test RTE instead of a vendor's, on one core",
    passes_time=True,
)
_WORDS = {"lock step": "lock", "free run": "free"}


def _missing(environment: Mapping[str, str]) -> str | None:
    path = environment.get("PATH")
    if not shutil.which("cmake", path=path) or not (environment.get("CC") or shutil.which("cc", path=path)):
        return "autosar-classic needs CMake and a C compiler: apt-get install cmake gcc"
    return None


def _build(subject: Subject, folder: Path, tools: Toolchain) -> Built:
    del tools  # CMake finds its own, by the same variables
    return bench.build(_BENCH, subject, folder)


def _play(built: Built, subject: Subject, drive: Drive) -> Recording:
    run = fresh_run(built, drive)
    program, sent = built.folder / "build/test_rte", run / "recorded.csv"
    kills = [f"{each.function}@{each.time_ns}" for each in drive.kills]
    normalized = write_normalized(drive.trace, subject.prepared, run / "normalized.tsv")
    files = (str(normalized), str(sent), str(run / "services.csv"))
    length = max(drive.end_ns - begin_of(drive.trace, subject.prepared), 0)
    command = (str(program), _WORDS[drive.mode], *files, str(length), *kills)
    environment = {**os.environ, **durations(drive, subject.prepared), marks.FOLDER: str(run / marks.NAME)}
    patience = drive.step_limit_s if drive.mode == "lock step" else length / 1e9 + drive.step_limit_s
    outcome = launched((), Process("test_rte", command, environment, (program,)), run, patience=patience)
    prepared = subject.prepared
    marked = marks.read_marks(prepared.connections, run / marks.NAME, 0)
    loads = tuple(each._replace(is_player=False) for each in outcome.loads)
    return Recording(
        NAME,
        drive.mode,
        built,
        read_recorded(sent, prepared.columns),
        marked.calls,
        loads,
        last_words=outcome.last_words,
        play_s=outcome.seconds,
        supervised=marked.supervised,
    )


AUTOSAR_CLASSIC = Runner(NAME, "AUTOSAR Classic", _missing, _build, _play, paper_platform="AUTOSAR")
