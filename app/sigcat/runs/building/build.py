"""A set of functions is generated, compiled and linked."""

import os
import shutil
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.core_files import CoreFiles, core_files
from sigcat.adapter.host.connections import Connections
from sigcat.adapter.host.glue import HOST_HEADER, glue_file
from sigcat.adapter.host.numbering import Numbers
from sigcat.adapter.toolchain import Toolchain
from sigcat.findings import Finding
from sigcat.runs.building.commands import Compilation, compilations, linking
from sigcat.runs.building.failures import Said, refused, warned
from sigcat.runs.driver.tables import tables_file

PROGRAM = "run.exe" if os.name == "nt" else "run"
_DRIVER = Path(__file__).parents[1] / "driver"


class Built(NamedTuple):
    """The program of a set of functions, and notes about their code."""

    program: Path
    findings: tuple[Finding, ...]


def build(connections: Connections, numbers: Numbers, folder: Path, tools: Toolchain, own: Sequence[str] = ()) -> Built:
    """The program of a set of functions, made in a folder. Raises InputRefused with what the compiler says.

    `own` are further flags for the code of functions, and for the linker.
    """
    cores = [core_files(member.plan) for member in connections.members]
    _write(connections, numbers, cores, folder)
    compiled = tuple(compilations(connections.members, folder, tools, own))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        printed = list(pool.map(_compiled, compiled))
    failed = [said for said in printed if said.has_failed]
    program = folder / PROGRAM
    if not failed:
        said = _said(linking(compiled, program, tools, own), None)
        failed = [said] if said.has_failed else []
    if failed:
        raise refused(failed, connections.members, cores)
    return Built(program, tuple(warned(printed, connections.members)))


def _write(connections: Connections, numbers: Numbers, cores: Sequence[CoreFiles], folder: Path) -> None:
    for path in (_DRIVER / "sigcat_driver.c", _DRIVER / "sigcat_driver.h", HOST_HEADER):
        shutil.copyfile(path, folder / path.name)
    glue = (glue_file(connections, numbers, index) for index in range(len(cores)))
    for file in (*(file for core in cores for file in core.files), *glue, tables_file(connections, numbers)):
        (folder / file.name).write_bytes(file.data)


def _compiled(one: Compilation) -> Said:
    return _said(one.command, one)


def _said(command: tuple[str, ...], one: Compilation | None) -> Said:
    """Run a command, and return its output."""
    environment = {**os.environ, "LC_ALL": "C", "GCC_COLORS": ""}
    done = subprocess.run(command, capture_output=True, check=False, env=environment)  # noqa: S603 — no shell
    return Said(one, (done.stderr or done.stdout).decode("utf-8", "replace"), done.returncode != 0)
