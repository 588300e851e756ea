"""When calls are due (section 9)."""

from dataclasses import dataclass
from typing import NamedTuple

NEVER = 2**64 - 1
"""Time of an event that does not happen."""


class Timing(NamedTuple):
    """When a call is due, as it is declared; in ns."""

    cycle: int | None = None
    """None: events trigger it."""
    offset: int = 0
    debounce: int = 0
    most_events: int = 1
    """Events that wait at most."""
    events_per_call: int = 1
    """Events that one call is for."""


@dataclass
class Activations:
    """The releases and events of a call."""

    timing: Timing
    next_release: int = NEVER
    events: int = 0
    begun: int | None = None
    """When it was called last."""
    is_active: bool = False
    """Whether it was answered and has not ended."""
    missed: int = 0
    dropped: int = 0
    overrun: bool | None = None
    """Whether releases were missed before this step."""

    def start(self, t: int) -> None:
        """The grid begins."""
        if self.timing.cycle:
            self.next_release = t + self.timing.offset

    def trigger(self) -> None:
        """An event came."""
        self.events = min(self.events + 1, self.timing.most_events)

    def drop(self, t: int) -> None:
        """Nothing that is due at a time or before it happens."""
        releases = self._releases(t)
        self.dropped += releases + self.events
        self.next_release += releases * (self.timing.cycle or 0)
        self.events = 0

    def _releases(self, t: int) -> int:
        """Return the number of releases up to a time."""
        cycle = self.timing.cycle
        return (t - self.next_release) // cycle + 1 if cycle and self.next_release <= t else 0

    def is_due(self, t: int) -> bool:
        """Whether it has to be called."""
        return not self.is_active and self.time() <= t

    def time(self) -> int:
        """When it is due; 0 if an event waits."""
        if not self.events and self.next_release == NEVER:
            return NEVER
        rested = 0 if self.begun is None else self.begun + self.timing.debounce
        return max(rested if self.timing.debounce else 0, 0 if self.events else self.next_release)

    def answer(self, t: int) -> None:
        """It is called now, once for everything that was missed."""
        late = self._releases(t)
        self.next_release += late * (self.timing.cycle or 0)
        self.missed += max(late - 1, 0)
        self.overrun = late > 1
        self.is_active = True

    def take(self) -> None:
        """Its snapshot is taken: the events of its values are over."""
        self.events = max(self.events - self.timing.events_per_call, 0)
