"""A file of expected outputs, opened for a run, and blocks of the run compared with it."""

import ctypes
from collections.abc import Collection, Sequence
from pathlib import Path

from sigcat.runs.expecting.comparison import Compared, Expectation
from sigcat.runs.expecting.tolerances import tolerances
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.trace_file import Known, Trace, open_trace
from sigcat.runs.running.rows import Block, Row, decoded
from sigcat.runs.simulate import layout_of


class Expected:
    """Compares blocks of a run with a file."""

    def __init__(self, file: Path, prepared: Prepared, paths: Collection[str], allowed: Sequence[str]) -> None:
        """Raise InputRefused if the file cannot be used, and UsageError for a tolerance."""
        exits = prepared.connections.exits
        aliases = {name: each.name for each in exits for name in each.names}
        shapes = {name: each.shape for each in exits for name in each.names}
        known = Known(shapes, {*paths, *prepared.inputs}, unused="the functions do not send it")
        self.trace: Trace = open_trace(file, known)
        self._exits, self._layout = exits, layout_of(prepared)
        self._expectation = Expectation(self.trace, aliases, tolerances(allowed, aliases))
        self._time = 0

    @property
    def columns(self) -> list[Compared]:
        """Columns that were compared."""
        return list(self._expectation.columns.values())

    def take(self, block: Block, library: ctypes.CDLL | None) -> None:
        """Compare a block."""
        del library
        for each in decoded(block, self._layout):
            self._time = each.time
            for number, value in each.values if isinstance(each, Row) else ():
                self._expectation.take(each.time, self._exits[number].name, value)

    def finish(self) -> None:
        """Compare the rest."""
        self._expectation.end(self._time)
