"""What a second is on the machine of the moment."""

from time import perf_counter

_ORDINARY = 0.05
"""Seconds that the piece of work below takes on an ordinary machine with nothing else to do."""


def is_within(seconds: float, allowed: float = 1) -> bool:
    """Whether this was quick enough. A machine that is slow, or busy with others, gets the time that it needs for more."""
    return seconds < allowed or seconds < allowed * _slowness()


def _slowness() -> float:
    start = perf_counter()
    sum(number * number for number in range(1_000_000))
    return max(1.0, (perf_counter() - start) / _ORDINARY)
