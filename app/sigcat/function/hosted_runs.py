"""Recordings in the folders of a service's functions: CSV files, known by their header.

A run is what `sigcat simulate` writes. A trace of inputs, or expected outputs, are other recordings.
"""

import csv
import logging
from collections.abc import Container, Iterable, Iterator, Sequence
from itertools import chain, count, islice
from pathlib import Path
from typing import NamedTuple

from sigcat.errors import NotFound
from sigcat.file_kind import RUN_COLUMNS, ending_of
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data, errors, safety_reactions
from sigcat.limits import RUN_HEADER_BYTES, RUNS
from sigcat.names import nearest

ENDING = ".csv"
FILE = "run.csv"
_log = logging.getLogger("sigcat.hosting")


class HostedRun(NamedTuple):
    """A stored run, or another recording. Its rows are read when a page shows them."""

    id: str
    """Name in addresses: of `NAME/run.csv` its folder, of any other file its own."""
    name: str
    """Name in notes."""
    path: Path
    group: str
    """Group of the functions that the run may belong to."""
    columns: tuple[str, ...]

    @property
    def is_run(self) -> bool:
        """Whether it has the calls of functions, as `sigcat simulate` writes them."""
        return self.columns[: len(RUN_COLUMNS)] == RUN_COLUMNS


HostedRuns = tuple[HostedRun, ...]


def is_run_name(name: str) -> bool:
    """Whether a file of this name may be a run, and can be named in an address."""
    return ending_of(name) == ENDING and name.isprintable()


def recordings_among(paths: Iterable[Path], folder: Path, group: str) -> Iterator[HostedRun]:
    """The runs among files below a folder, then other recordings, with unique ids."""
    found = [(path, columns) for path in paths if is_run_name(path.name) and (columns := recorded_columns(path))]
    found.sort(key=lambda each: each[1][: len(RUN_COLUMNS)] != RUN_COLUMNS)
    if len(found) > RUNS:
        _log.warning("%s: of %d recordings the first %d are shown", folder, len(found), RUNS)
    taken: set[str] = set()
    for path, columns in islice(found, RUNS):
        below = path.relative_to(folder)
        run_id = free_id(below.stem if below.name != FILE else below.parent.name or folder.name, taken)
        taken.add(run_id)
        yield HostedRun(run_id, (Path(folder.name) / below).as_posix(), path, group, columns)


def free_id(wanted: str, taken: Container[str]) -> str:
    """The id; of one that is taken, the first free one with a number: `drive-2`."""
    numbered = (f"{wanted}-{number}" for number in count(2))
    return next(each for each in chain((wanted,), numbered) if each not in taken)


def recorded_columns(path: Path) -> tuple[str, ...]:
    """The columns of a recording; none if the file is something else, or cannot be read."""
    try:
        with path.open("rb") as file:
            line = file.readline(RUN_HEADER_BYTES)
        text = line.decode("utf-8-sig")
        columns = tuple(cell.strip() for cell in next(csv.reader([text]), ()))
    except OSError as error:
        _log.warning("%s: %s", path, error.strerror or error)
        return ()
    except (UnicodeDecodeError, csv.Error):
        return ()
    return columns if columns[:1] == RUN_COLUMNS[:1] else ()


def runs_of(function: FunctionJson, group: str, runs: Iterable[HostedRun]) -> HostedRuns:
    """The runs of a function: those of its folder that have something which it alone sends, if there is such."""
    sent = frozenset(_sent(function)) or frozenset(each.name for _, _, each in safety_reactions(function))
    return tuple(run for run in runs if run.is_run and run.group == group and not sent.isdisjoint(run.columns))


def beside_runs(group: str, columns: Iterable[str], recordings: Iterable[HostedRun]) -> HostedRuns:
    """The recordings of a group that have one of some columns."""
    wanted = frozenset(columns)
    return tuple(each for each in recordings if each.group == group and not wanted.isdisjoint(each.columns))


def _sent(function: FunctionJson) -> Iterator[str]:
    """Columns that only this function writes; a safety reaction is decided by each function that has it."""
    yield from (item.vss_path or item.name for _, _, item in data(function) if item.role == PROVIDER)
    yield from (item.name for _, _, item in errors(function))
    yield from (item.name for item in function.mode_interfaces or () if item.direction == "Out")


def run_named(run_id: str, runs: Sequence[HostedRun]) -> HostedRun:
    """A run of a function by its id, the first one if that is empty. Raises NotFound with the nearest ids."""
    known = {run.id: run for run in runs}
    if not runs or (run_id and run_id not in known):
        raise NotFound(f"Unknown run {run_id[:100]!r}.", nearest(run_id[:100], known))
    return known[run_id] if run_id else runs[0]
