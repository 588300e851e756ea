"""Supervision of calls: alive, deadline and logical (section 10)."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple


class AliveLimits(NamedTuple):
    """Limits for the number of ends of a call in a window."""

    least: int
    most: int
    window: int
    """In ns."""
    error: str


@dataclass
class Alive:
    """Windows in which the ends of a call are counted."""

    limits: AliveLimits
    begun: int | None = None
    """Start of the window; None while there is none."""
    count: int = 0
    closed: list[bool] = field(default_factory=list)
    """Counts of bad windows, and of one good one, among those that closed since the last evaluation."""
    verdict: bool | None = None

    def begin(self, t: int) -> None:
        """Windows begin at a time."""
        self.begun, self.count = t, 0

    def stop(self) -> None:
        """End all windows."""
        self.begun, self.count, self.closed, self.verdict = None, 0, [], None

    def close(self, t: int) -> None:
        """Close the windows that are over."""
        passed = 0 if self.begun is None or t < self.begun else (t - self.begun) // self.limits.window
        if passed and self.begun is not None:
            self.closed.append(self._is_bad(self.count))
            self.closed += [self._is_bad(0)] if passed > 1 else []
            self.begin(self.begun + passed * self.limits.window)

    def _is_bad(self, count: int) -> bool:
        return not self.limits.least <= count <= self.limits.most

    def indicate(self, t: int) -> None:
        """The call has ended."""
        self.close(t)
        if self.begun is not None and t >= self.begun:
            self.count += 1

    def evaluate(self) -> bool | None:
        """Whether one of the windows was bad; as before if none has closed."""
        if self.closed:
            self.verdict, self.closed = any(self.closed), []
        return self.verdict

    @property
    def end(self) -> int | None:
        """End of the window."""
        return None if self.begun is None else self.begun + self.limits.window


class DeadlineLimits(NamedTuple):
    """Limits of the duration of a call; in ns."""

    least: int
    most: int
    error: str


@dataclass
class Deadline:
    """Duration of a call."""

    limits: DeadlineLimits
    begun: int | None = None
    """None while it does not run."""
    verdict: bool | None = None

    def begin(self, t: int) -> None:
        """The call begins."""
        self.begun = t

    def supervise(self, t: int) -> None:
        """Whether a call that runs takes too long."""
        if self.begun is not None and t - self.begun > self.limits.most:
            self.verdict = True

    def end(self, t: int) -> None:
        """The call has ended."""
        if self.begun is not None:
            self.verdict = not self.limits.least <= t - self.begun <= self.limits.most
        self.begun = None


class Checkpoint(NamedTuple):
    """A call in the graph."""

    is_initial: bool
    is_final: bool
    next: tuple[str, ...]
    error: str | None


@dataclass
class Graph:
    """The order of calls."""

    checkpoints: Mapping[str, Checkpoint]
    """By the names of calls."""
    active: str | None = None
    verdicts: dict[str, bool] = field(default_factory=dict)
    """Whether a wrong one came last, by errors."""

    def report(self, call: str) -> None:
        """A call comes."""
        checkpoint = self.checkpoints.get(call)
        if checkpoint is None:
            return
        follows = self.active is not None and call in self.checkpoints[self.active].next
        if follows or (self.active is None and checkpoint.is_initial):
            self.active = None if checkpoint.is_final else call
            self.verdicts = {each.error: False for each in self.checkpoints.values() if each.error is not None}
        elif checkpoint.error is not None:
            self.verdicts[checkpoint.error] = True
