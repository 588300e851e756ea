"""The core of a function as files: a header and a source."""

from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.c.header import header
from sigcat.adapter.core.c.names.scope import Scope, in_adapter
from sigcat.adapter.core.c.names.shadowing import distinct
from sigcat.adapter.core.c.source import source
from sigcat.adapter.core.c.text.lines import file_of, wrapped
from sigcat.adapter.core.numbers import DOUBLE, NumberType
from sigcat.adapter.core.plan import NANOSECONDS, Clock, CorePlan
from sigcat.adapter.files import GeneratedFile
from sigcat.function.document.document import Pointer

_RUNTIME = Path(__file__).with_name("runtime")
RUNTIME_SOURCE = "sigcat_core.c"
"""File that is compiled once for all cores of a program."""


@cache
def runtime_files(arithmetic: NumberType = DOUBLE, clock: Clock = NANOSECONDS) -> tuple[GeneratedFile, ...]:
    """Return files of C that all cores of a program share, as they are in the package."""
    folders = (_RUNTIME, *(_RUNTIME / name for name in (arithmetic.name, *clock.folders)))
    paths = (path for folder in folders for path in folder.glob("*.[ch]"))
    return tuple(GeneratedFile(path.name, path.read_bytes()) for path in sorted(paths, key=lambda path: path.name))


class CoreFiles(NamedTuple):
    """Header and source, and the origin of each line of the source."""

    header: GeneratedFile
    source: GeneratedFile
    origins: dict[tuple[str, int], Pointer]
    """Pointers into Function JSON, by file name and line."""
    runtime: tuple[GeneratedFile, ...]
    """Files that all cores of a program share."""

    @property
    def files(self) -> tuple[GeneratedFile, ...]:
        """All that a program needs."""
        return self.header, self.source, *self.runtime


def all_files(plans: Iterable[CorePlan]) -> tuple[GeneratedFile, ...]:
    """Return the files of several cores of one arithmetic and one clock; those that all cores share are there once."""
    cores = [core_files(plan) for plan in plans]
    own = (file for core in cores for file in (core.header, core.source))
    return (*own, *dict.fromkeys(file for core in cores for file in core.runtime))


def core_files(plan: CorePlan) -> CoreFiles:
    """The files of a core. The same plan gives the same bytes."""
    names = plan.header_file, plan.source_file
    parts = wrapped(header(Scope(plan))), wrapped(distinct(plan, source(in_adapter(plan))))
    origins = {
        (name, number): line.source
        for name, part in zip(names, parts, strict=True)
        for number, line in enumerate(part, 1)
        if line.source is not None
    }
    made = [file_of(name, part) for name, part in zip(names, parts, strict=True)]
    return CoreFiles(made[0], made[1], origins, runtime_files(plan.arithmetic, plan.clock))
