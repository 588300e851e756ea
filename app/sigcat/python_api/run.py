"""Functions that run with a trace, in simulated time: rows as they are sent, or one Arrow table."""

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.python_api.function import Function
from sigcat.python_api.opening import PathLike
from sigcat.python_api.rows import Row, arrow_table

if TYPE_CHECKING:
    import pyarrow as pa

    from sigcat.findings import Finding
    from sigcat.runs.prepare import Prepared
    from sigcat.runs.recording.trace_file import Trace
    from sigcat.runs.simulate import Settings


class Run:
    """A run of functions. Each iteration builds and runs them again, with the same rows."""

    def __init__(self, prepared: "Prepared", trace: "Trace | None", settings: "Settings") -> None:
        self._prepared, self._trace, self._settings = prepared, trace, settings

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of everything that the functions send."""
        return tuple(self._prepared.columns)

    @property
    def units(self) -> Mapping[str, str]:
        """Units by name; names without a unit are omitted."""
        return self._prepared.connections.units

    @property
    def findings(self) -> "tuple[Finding, ...]":
        """Warnings about the functions and the trace."""
        return (*self._prepared.findings, *(self._trace.findings if self._trace else ()))

    def __iter__(self) -> Iterator[Row]:
        """Build and run the functions. Raises InputRefused, after the rows so far, if the run stops before its end."""
        from sigcat.adapter.toolchain import toolchain
        from sigcat.runs.recording.recorded import split
        from sigcat.runs.running.rows import Row as Sent
        from sigcat.runs.running.rows import decoded
        from sigcat.runs.simulate import layout_of, recorded, simulated_blocks

        layout = layout_of(self._prepared)
        with closing(simulated_blocks(self._prepared, self._trace, self._settings, toolchain())) as blocks:
            while True:
                try:
                    block, _ = next(blocks)
                except StopIteration as end:
                    if end.value.stop is not None:
                        raise end.value.stop from None
                    return
                for each in decoded(block, layout):
                    if isinstance(each, Sent):
                        for row in split(recorded(each, self._prepared)):
                            yield Row(row.time, row.call, dict(row.values))

    def table(self) -> "pa.Table":
        """Run the functions and return an Arrow table: time (duration in ns), call, and a column for each thing sent.

        A cell without a new value is null. Raises UsageError without the package pyarrow.
        """
        return arrow_table(self, self._prepared.columns)

    def __repr__(self) -> str:
        return f"<sigcat.Run of {', '.join(member.name for member in self._prepared.connections.members)}>"


def simulate(
    functions: Sequence[Function],
    trace: PathLike | None = None,
    *,
    duration: float | None = None,
    ignition_cycle: int = 1,
    step_limit: float = 10.0,
    sandbox: bool = False,
) -> Run:
    """Prepare a run of functions with a trace in CSV or MCAP; iterate over it, or ask for its table.

    `duration` is in seconds, by default to the end of the trace. The other arguments are the options of
    `sigcat simulate`. What the functions print is discarded. Raises InputRefused with findings, or UsageError.
    """
    from sigcat.runs.prepare import prepare
    from sigcat.runs.recording.times import NANOSECONDS
    from sigcat.runs.recording.traces import open_trace
    from sigcat.runs.running.sandbox import check_sandbox
    from sigcat.runs.simulate import Settings

    if sandbox:
        check_sandbox()
    prepared = prepare([function._resolved for function in functions])
    known = prepared.known_columns({path for function in functions for path in function._known})
    opened = open_trace(Path(trace), known) if trace is not None else None
    nanoseconds = None if duration is None else round(duration * NANOSECONDS)
    printed = Path(os.devnull)
    settings = Settings(nanoseconds, ignition_cycle, step_limit, prints=printed, is_sandboxed=sandbox)
    return Run(prepared, opened, settings)
