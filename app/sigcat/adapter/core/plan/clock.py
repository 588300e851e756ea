"""The clock of a core (section 1)."""

from typing import NamedTuple


class Clock(NamedTuple):
    """Nanoseconds in 64 bits, or ticks in 32 bits, which wrap around."""

    tick: int = 1
    """Nanoseconds of a tick."""
    unit: str = "Nanoseconds"
    """Unit of a tick: in the name of the function that makes a time."""
    reason: str = ""
    """Why it is this one, for readers; empty if there was no choice."""

    @property
    def is_in_ticks(self) -> bool:
        """Whether times wrap around."""
        return self.tick > 1

    @property
    def folders(self) -> tuple[str, ...]:
        """Folders of the shared files that count time."""
        own = self.unit.lower()
        return ("ticks", own) if self.is_in_ticks else (own,)

    @property
    def type(self) -> str:
        """Type of a time within the core."""
        return "uint32_t" if self.is_in_ticks else "uint64_t"

    @property
    def given(self) -> str:
        """Type of a time that the platform passes: one that no number turns into, so that it is in the right unit."""
        return "Sigcat_Time" if self.is_in_ticks else "uint64_t"

    def constant(self, nanoseconds: int) -> str:
        """A declared time, in C."""
        return f"UINT{32 if self.is_in_ticks else 64}_C({nanoseconds // self.tick})"

    def now(self, prefix: str) -> str:
        """An expression for the time, where `t` was passed."""
        return f"{prefix}_Now(self, t)" if self.is_in_ticks else "Sigcat_Now(&self->now, t)"

    def is_reached(self, time: str, now: str) -> str:
        """The condition that a time is now or over."""
        return f"Sigcat_IsReached({time}, {now})" if self.is_in_ticks else f"{now} >= {time}"

    def until(self, time: str) -> str:
        """The time; in ticks how long it is until then, since times that wrap around have no order."""
        return f"Sigcat_Until({time}, self->now)" if self.is_in_ticks else time


NANOSECONDS = Clock()
MICROSECONDS = Clock(1_000, "Microseconds")
MILLISECONDS = Clock(1_000_000, "Milliseconds")
LONGEST = 2**28 - 1
"""Ticks of the longest declared time: few enough that times which are over are in order with those to come."""
