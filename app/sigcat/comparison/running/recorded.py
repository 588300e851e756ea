"""Folder of a run, and what a player recorded in it, with the names and texts of the simulation."""

import csv
import shutil
from collections import defaultdict
from collections.abc import Iterable, Mapping
from pathlib import Path

from sigcat.adapter.host.shapes import Shape, packing
from sigcat.comparison.recording import Built, Sent
from sigcat.comparison.running import marks
from sigcat.comparison.running.runner import Drive
from sigcat.errors import UsageError
from sigcat.runs.normalize import normalize, with_codes
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.cells import Unfit, cell_of, value_of
from sigcat.runs.recording.trace_file import moments, open_trace

_COLUMNS = ("time", "name", "value")


def fresh_run(built: Built, drive: Drive) -> Path:
    """A folder for what a run records, beside those of other runs; it has one for the marks of cores."""
    folder = built.folder / "runs" / f"{built.platform}-{drive.name}"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / marks.NAME).mkdir(parents=True)
    return folder


def begin_of(trace: Path, prepared: Prepared) -> int:
    """When a drive begins, in ns: with the first row of its trace; 0 without one."""
    rows = moments(open_trace(trace, prepared.known_in_drive))
    return next((row.time for row in rows), 0)


def write_normalized(trace: Path, prepared: Prepared, path: Path) -> Path:
    """Write a trace as players and the test RTE read it. Raises InputRefused with all errors in it."""
    known = with_codes(prepared.known_in_drive, prepared)
    with path.open("w", newline="", encoding="utf-8") as file:
        file.writelines(normalize(open_trace(trace, known), prepared))
    return path


def write_recorded(sent: Mapping[str, Iterable[Sent]], path: Path) -> None:
    """Rows as players write them, in order of time."""
    rows = sorted((time, name, text) for name, values in sent.items() for time, text in values)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(_COLUMNS)
        writer.writerows(rows)


def read_recorded(path: Path, columns: Mapping[str, Shape]) -> Mapping[str, tuple[Sent, ...]]:
    """Rows of time in ns, name and value, by name. A last row that was cut off is skipped.

    Raises UsageError for any other row that is damaged.
    """
    found: defaultdict[str, list[Sent]] = defaultdict(list)
    if not path.exists():
        return {}
    damaged = 0
    with path.open(newline="", encoding="utf-8", errors="replace") as file:
        for line, row in enumerate(csv.reader(file), 1):
            if damaged:
                raise UsageError(f"{path}:{damaged}: the row must have {', '.join(_COLUMNS)}, with the time in ns")
            if len(row) == len(_COLUMNS) and row[0].isdigit():
                found[row[1]].append((int(row[0]), _text(row[2], columns.get(row[1]))))
            elif line > 1:
                damaged = line
    return {name: tuple(values) for name, values in found.items()}


def _text(text: str, shape: Shape | None) -> str:
    """The text that the simulation has for the same bits; what is no such value stays as it is."""
    if shape is None:
        return text
    try:
        packed = packing(shape)
        return cell_of(packed.unpack(packed.pack(value_of(text, shape))), shape)  # a float has the bits of a float
    except Unfit:
        return text
