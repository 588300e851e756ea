"""A platform of AUTOSAR, with a replacement of a vendor's part of it: one project of CMake."""

import time
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from sigcat.comparison.recording import Built
from sigcat.comparison.running import marks
from sigcat.comparison.running.generated import generated
from sigcat.comparison.running.runner import Subject
from sigcat.comparison.running.slow_calls import with_slow_calls
from sigcat.players import cmake
from sigcat.players.commands import write


class Bench(NamedTuple):
    """Test bench of a platform."""

    platform: str
    folders: tuple[str, ...]
    """Folders that replace a vendor's part: their lines are not counted."""
    note: str
    """Note for readers about the bench."""
    settings: Mapping[str, object] = {}
    """Settings of CMake, besides those of every platform."""
    passes_time: bool = False
    """Whether it runs others while a call takes time."""


def build(bench: Bench, subject: Subject, folder: Path) -> Built:
    """Generate and compile. Raises InputRefused, or BuildFails with what the compiler says."""
    made = generated(subject, bench.platform, bench=True)
    members = subject.prepared.connections.members
    write(with_slow_calls(made.files, members, passes_time=bench.passes_time), folder)
    (folder / "integration.json").write_bytes(made.integration)
    begin = time.monotonic()
    measured = marks.cmake_settings(members, folder / "marks")
    cmake.build(folder, folder / "build", {**subject.code_settings, **measured, **bench.settings})
    own = tuple(file for file in made.files if not file.name.startswith(bench.folders))
    return Built(bench.platform, folder, own, made.seconds, time.monotonic() - begin, (bench.note,))
