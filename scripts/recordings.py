"""Values that a platform has sent while a drive was played to it, and those that `sigcat simulate` sends."""

import csv
import json
import struct
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

EXAMPLES = Path(__file__).parents[1] / "examples"
DRIVE = EXAMPLES / "ecocontrol/drive.csv"
FUNCTIONS = ("core_acc", "eco_control_mpc")
WHOLE_DRIVE = 600
"""Seconds."""

Sent = Mapping[str, list[tuple[int, str]]]
"""Sent values by name: times in ns and values."""


def simulated(out: Path, seconds: int) -> Sent:
    """Return the values that the simulation of EcoControl sends."""
    _run("simulate", "--duration", str(seconds), "-o", str(out))
    return _by_name(_simulated_values(out))


def normalized(out: Path) -> Path:
    """Write the drive as players read it."""
    _run("normalize", "-o", str(out))
    return out


def _run(command: str, *options: str) -> None:
    functions = [str(EXAMPLES / name / "function.yaml") for name in FUNCTIONS]
    sigcat = [sys.executable, "-m", "sigcat.cli", command, *functions, "--trace", str(DRIVE), *options]
    subprocess.run(sigcat, check=True, capture_output=True, text=True)


def _simulated_values(path: Path) -> Iterator[tuple[int, str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            time = round(float(row.pop("time")) * 1e9)
            yield from ((time, name, value) for name, value in row.items() if value and name != "call")


def recorded(path: Path) -> Sent:
    """Read the recording of a player: rows of time in ns, name and value."""
    with path.open(newline="", encoding="utf-8") as file:
        return _by_name((int(row["time"]), row["name"], row["value"]) for row in csv.DictReader(file))


def _by_name(values: Iterable[tuple[int, str, str]]) -> Sent:
    found: defaultdict[str, list[tuple[int, str]]] = defaultdict(list)
    for time, name, value in values:
        found[name].append((time, value))
    return found


def bits(value: str) -> object:
    """The bits of a float."""
    try:
        number = json.loads(value)
    except ValueError:
        return value
    return struct.pack("<f", number) if isinstance(number, float | int) else number
