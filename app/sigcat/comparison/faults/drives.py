"""Drives with faults in them: as many scenarios in one drive as fit, since whoever is killed does not come back."""

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.comparison.faults.scenario import Scenario
from sigcat.comparison.faults.spoiling import TextRow, TextTrace, spoil
from sigcat.comparison.recording import Recording
from sigcat.comparison.running.runner import Drive, Kill
from sigcat.errors import UsageError
from sigcat.runs.recording.times import nanoseconds, seconds
from sigcat.runs.recording.trace_file import TIME


class FaultyDrive(NamedTuple):
    """A drive, and the scenarios in it."""

    drive: Drive
    scenarios: tuple[Scenario, ...]


def faulty_drives(scenarios: Sequence[Scenario], trace: Path, folder: Path) -> tuple[FaultyDrive, ...]:
    """The drives, written to a folder. Each one ends with its last scenario."""
    rows = read_texts(trace)
    folder.mkdir(parents=True, exist_ok=True)
    drives = []
    for number, group in enumerate(grouped(scenarios)):
        path = folder / f"faults-{number + 1}.csv"
        spoilt = [fault for each in group for fault in each.spoilt]
        write_texts(spoil(rows, spoilt, [fault for each in group for fault in each.slow]), path)
        kills = tuple(Kill(fault.function, fault.at) for each in group for fault in each.killed)
        drives.append(
            FaultyDrive(Drive(path, max(each.end for each in group), name=f"faults-{number + 1}", kills=kills), group)
        )
    return tuple(drives)


def grouped(scenarios: Sequence[Scenario]) -> tuple[tuple[Scenario, ...], ...]:
    """Scenarios of one drive: those without a kill together, with the last that kills if it comes after them."""
    lasting = sorted((each for each in scenarios if not each.killed), key=lambda each: each.start)
    killing = sorted((each for each in scenarios if each.killed), key=lambda each: each.start)
    if lasting and killing and killing[-1].start >= max(each.end for each in lasting):
        lasting.append(killing.pop())
    return tuple(filter(None, (tuple(lasting), *((each,) for each in killing))))


def watched(recording: Recording, scenario: Scenario) -> Recording:
    """Return the part of a recording in the time of a scenario."""
    sent = {
        name: tuple(each for each in values if scenario.start <= each[0] < scenario.end)
        for name, values in recording.sent.items()
    }
    calls = tuple(each for each in recording.calls if scenario.start <= each.time_ns < scenario.end)
    return recording._replace(sent={name: values for name, values in sent.items() if values}, calls=calls)


def read_texts(path: Path) -> TextTrace:
    """A trace as texts. Raises UsageError; `open_trace` gives the place of the error."""
    with path.open(newline="", encoding="utf-8-sig") as file:
        lines = csv.reader(file)
        header = next(lines, [])
        rows = [TextRow(nanoseconds(cells[0]) or 0, tuple(cells[1:])) for cells in lines if cells]
    if header[:1] != [TIME] or any(len(row.cells) != len(header) - 1 for row in rows):
        raise UsageError(f"{path} is not a trace")
    return TextTrace(tuple(header[1:]), tuple(rows))


def write_texts(trace: TextTrace, path: Path) -> None:
    """Write it as it was read."""
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([TIME, *trace.columns])
        writer.writerows([seconds(row.time), *row.cells] for row in trace.rows)
