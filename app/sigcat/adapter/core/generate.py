"""The core of a function as files: a header and a source."""

from typing import NamedTuple

from sigcat.adapter.core.c.header import header
from sigcat.adapter.core.c.lines import Lines, wrapped
from sigcat.adapter.core.c.scope import Scope, in_adapter
from sigcat.adapter.core.c.shadowing import distinct
from sigcat.adapter.core.c.source import source
from sigcat.adapter.core.plan import CorePlan
from sigcat.adapter.files import GeneratedFile
from sigcat.function.document.document import Pointer


class CoreFiles(NamedTuple):
    """Header and source, and what each line of the source was made from."""

    header: GeneratedFile
    source: GeneratedFile
    origins: dict[tuple[str, int], Pointer]
    """Pointers into Function JSON, by file name and line."""

    @property
    def files(self) -> tuple[GeneratedFile, ...]:
        """Both of them."""
        return self.header, self.source


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
    made = [GeneratedFile(name, _text(part)) for name, part in zip(names, parts, strict=True)]
    return CoreFiles(made[0], made[1], origins)


def _text(part: Lines) -> bytes:
    return ("\n".join(line.text for line in part) + "\n").encode()
