"""Time-outs: whether what is received is late (section 3)."""

from dataclasses import dataclass

LAST, DEFAULT = "Last", "Default"


@dataclass(frozen=True)
class TimeOut:
    """Limits of an input."""

    longest: int
    """In ns, as are all times."""
    starts_with_first: bool = False
    recovery: int = 1
    """Values that end it."""
    substitute: str = LAST
    """Value that the call sees meanwhile: Last, Default or Init."""


@dataclass
class Clock:
    """Age of the last value, and whether it is late."""

    limits: TimeOut
    started: int = 0
    received: int | None = None
    since_tested: int = 0
    """Values received since it expired."""
    recovering: int = 0
    """Values that came in time since it expired."""
    is_expired: bool = False
    verdict: bool | None = None
    """Whether it is expired; None while this is not tested."""

    def restart(self, t: int) -> None:
        """Earlier late values do not count."""
        self.started = t

    def receive(self, t: int) -> None:
        """A value came."""
        self.received = t
        self.since_tested += 1

    def evaluate(self, t: int) -> None:
        """Decide whether it is late."""
        is_late = self._is_late(t)
        if not self.is_expired or is_late:
            self.recovering = 0
        else:
            self.recovering += self.since_tested
        self.is_expired = is_late or (self.is_expired and self.recovering < self.limits.recovery)
        self.since_tested = 0
        self.verdict = self.is_expired if self.is_expired or self.received is not None else None

    def _is_late(self, t: int) -> bool:
        if self.received is None and self.limits.starts_with_first:
            return False
        return t - max(self.received or 0, self.started) > self.limits.longest
