"""The report of a command that finds things while it runs."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output import write_text
from sigcat.errors import InputRefused

if TYPE_CHECKING:
    from sigcat.findings import Finding


@contextmanager
def reported(output: Path | None, form: str) -> "Iterator[list[Finding]]":
    """Collect findings, and write them if an output is named: also of a refused input, but not if the command could not run."""
    from sigcat.rules.report import report, sources_of

    found: list[Finding] = []
    refused: InputRefused | None = None
    try:
        yield found
    except InputRefused as error:
        refused = error
        found += error.findings
    if output is not None:
        write_text(report(found, form, sources_of(found)), output)
    if refused is not None:
        raise refused
