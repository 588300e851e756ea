"""Everything that was done for a comparison: what a report is made of."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.comparison.effort import Counted
from sigcat.comparison.recording import Built, Recording
from sigcat.runs.columns import Column


class Played(NamedTuple):
    """A platform."""

    name: str
    title: str
    left_out: str = ""
    """Why it was not played to; empty if it was."""
    build_error: str = ""
    """Message of the tool that could not build it."""
    built: Built | None = None
    lock_step: Recording | None = None
    free_run: Recording | None = None
    repeats: tuple[Recording, ...] = ()
    """Further runs, for the spread of their load."""
    is_by_hand: bool = False
    """Whether people wrote it, for comparison: nothing of it is sigcat's."""

    @property
    def recordings(self) -> tuple[Recording, ...]:
        """All of them."""
        return tuple(each for each in (self.lock_step, self.free_run) if each)


class PlayedFault(NamedTuple):
    """A fault, and what each platform did."""

    name: str
    title: str
    description: str
    recordings: Mapping[str, Recording]
    """By platform."""


class WrittenLines(NamedTuple):
    """Lines that a person wrote."""

    what: str
    platform: str
    """Empty: for all platforms."""
    lines: Counted


class Material(NamedTuple):
    """All of it. The first platform is the reference."""

    name: str
    functions: tuple[str, ...]
    trace: str
    end_ns: int
    columns: Mapping[str, Column]
    """Columns that the functions send, by name."""
    cycle_ns: int
    """Cycle of the most frequent call."""
    platforms: tuple[Played, ...]
    faults: tuple[PlayedFault, ...] = ()
    written: tuple[WrittenLines, ...] = ()
    seconds: float = 0.0
    machine: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()
    translation_ns: Sequence[int] = ()
    """Times of the gateway for each frame, if the drive was logged on CAN."""
    phases: tuple[tuple[str, float], ...] = ()
    """Phases of the comparison, in s."""
    begin_ns: int = 0
    """Time of the first row of the drive."""

    @property
    def drive_seconds(self) -> float:
        """Length of the drive."""
        return (self.end_ns - self.begin_ns) / 1e9

    @property
    def reference(self) -> Played:
        """The platform that all others are compared with."""
        return self.platforms[0]
