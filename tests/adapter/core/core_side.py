"""A script, done by a generated core: compiled with a driver, run, and what it printed."""

import subprocess
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from sigcat.adapter.core.core_files import RUNTIME_SOURCE, core_files, runtime_files
from sigcat.adapter.core.plan import CLASS
from sigcat.adapter.toolchain import EXACT, toolchain
from tests.adapter.core.driver import HELPERS, header, program
from tests.adapter.core.script import Script, written
from tests.adapter.core.subject import Subject

_LONGEST = 60
"""Seconds that a run may take."""


def texts(subject: Subject) -> dict[str, str]:
    """Texts that decide what a core does, by the names of their files."""
    files = (core_files(subject.plan).source, *runtime_files(subject.plan.arithmetic, subject.plan.clock))
    return {file.name: file.data.decode() for file in files if file.name != "sigcat_core_checks.h"}


def write(subject: Subject, folder: Path) -> Path:
    """Write the core, the function and the driver as one program."""
    folder.mkdir(parents=True, exist_ok=True)
    files = core_files(subject.plan)
    for file in files.files:
        (folder / file.name).write_bytes(file.data)
    write_headers(subject, folder)
    (folder / HELPERS.name).write_text(HELPERS.read_text())
    source = folder / ("program.cpp" if subject.signature == CLASS else "program.c")
    source.write_text(program(subject, [RUNTIME_SOURCE, files.source.name]))
    return source


def write_headers(subject: Subject, folder: Path, guard: str = "F_H") -> None:
    """Write the headers that the document names: each declares the code, and is included once."""
    for name in subject.headers:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(header(subject, guard))


def compiled(
    subject: Subject,
    folder: Path,
    flags: Sequence[str] = ("-O0",),
    exact: Sequence[str] = EXACT,
    change: Callable[[Mapping[str, str]], Mapping[str, str]] | None = None,
) -> Path:
    """Write a program and compile it; `change` may break the core before."""
    source, result = write(subject, folder), folder / "program"
    if change is not None:
        for name, text in change(texts(subject)).items():
            (folder / name).write_text(text)
    is_class = subject.signature == CLASS
    command = toolchain().cpp if is_class else toolchain().c
    standard = "-std=c++17" if is_class else "-std=c99"
    line = [*command, standard, *flags, *exact, source.name, "-o", result.name]
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{' '.join(line)}\n{done.stderr}"
    return result


def run(program_file: Path, script: Script) -> list[str]:
    """Return the output of a script."""
    done = subprocess.run(
        [program_file], input=written(script), capture_output=True, text=True, timeout=_LONGEST, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()
