"""A trace in any of its forms, by the ending of its file."""

from collections.abc import Iterator
from pathlib import Path

from sigcat.runs.recording import trace_file
from sigcat.runs.recording.mcap_trace import SUFFIX, mcap_moments, open_mcap
from sigcat.runs.recording.trace_file import Known, Moment, Trace


def open_trace(path: Path, known: Known) -> Trace:
    """A trace by its header, or its topics. Raises InputRefused, or UsageError without the package `mcap`."""
    return open_mcap(path, known) if path.suffix.lower() == SUFFIX else trace_file.open_trace(path, known)


def moments(trace: Trace) -> Iterator[Moment]:
    """Rows of a trace, by time. Raises InputRefused at its end, with everything that was wrong with it."""
    return mcap_moments(trace) if trace.known is not None else trace_file.moments(trace)
