"""Processes of a service: itself, and all that were started by it or by one of those."""

import os
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

PROC = Path("/proc")


def family(process: int) -> Sequence[int]:
    """A process and all below it, as they are now."""
    children: dict[int, list[int]] = {}
    for folder in PROC.iterdir():
        if folder.name.isdecimal():
            with suppress(OSError):
                parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
                children.setdefault(parent, []).append(int(folder.name))
    found = [process]
    for each in found:
        found += children.get(each, ())
    return found


def is_running(process: int) -> bool:
    """Whether the process is there, and not just waited for."""
    with suppress(OSError):
        return (PROC / str(process) / "stat").read_text().rpartition(")")[2].split()[0] != "Z"
    return False


def is_stopped(process: int) -> bool:
    """Whether a signal has stopped the process."""
    return (PROC / str(process) / "stat").read_text().rpartition(")")[2].split()[0] == "T"


def memory(process: int) -> int:
    """Bytes that a process and all below it hold, what they share counted once."""
    total = 0
    for each in family(process):
        with suppress(OSError):
            lines = (PROC / str(each) / "smaps_rollup").read_text().splitlines()
            total += sum(int(line.split()[1]) for line in lines if line.startswith("Pss:")) * 1024
    return total


def seconds(process: int) -> float:
    """Seconds of the processor that a process and all below it have used, those that ended included."""
    ticks = 0
    for each in family(process):
        with suppress(OSError):
            ticks += sum(map(int, (PROC / str(each) / "stat").read_text().rpartition(")")[2].split()[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")
