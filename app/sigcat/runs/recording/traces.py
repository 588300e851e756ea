"""A trace in any of its forms: CSV, MCAP in JSON, or a bag of ROS 2."""

from collections.abc import Iterator
from pathlib import Path
from types import MappingProxyType

from sigcat.errors import existing_file
from sigcat.runs.recording import trace_file
from sigcat.runs.recording.mcap_trace import SUFFIX, mcap_moments, open_mcap
from sigcat.runs.recording.ros2_bag import BagColumns, bag_as_csv, is_bag
from sigcat.runs.recording.trace_file import Known, Moment, Trace
from sigcat.temporary_files import temporary_folder


def open_trace(path: Path, known: Known, mapped: BagColumns = MappingProxyType({})) -> Trace:
    """A trace by its header, or its topics. Raises InputRefused, or UsageError if there is no such file, or without the package `mcap`."""
    if is_bag(path):
        return _open_bag(path, known, mapped)
    existing_file(path)
    return open_mcap(path, known) if path.suffix.lower() == SUFFIX else trace_file.open_trace(path, known)


def _open_bag(path: Path, known: Known, mapped: BagColumns) -> Trace:
    folder = temporary_folder("sigcat-bag-")
    notes = bag_as_csv(path, Path(folder.name) / f"{path.name}.csv", known, mapped)
    trace = trace_file.open_trace(Path(folder.name) / f"{path.name}.csv", known)
    found = (*notes, *(each._replace(file=str(path)) for each in trace.findings))
    return trace._replace(findings=found, folder=folder, bag=path)


def moments(trace: Trace) -> Iterator[Moment]:
    """Rows of a trace, by time. Raises InputRefused at its end, with everything that was wrong with it."""
    return mcap_moments(trace) if trace.known is not None else trace_file.moments(trace)
