"""Wait for what happens elsewhere: in another process, in another thread."""

from collections.abc import Callable
from time import monotonic, sleep
from typing import TypeVar

T = TypeVar("T")
DEADLINE = 120.0
"""Seconds after which something is not merely late. A test that passes never waits for them."""


def wait_until(condition: Callable[[], T], what: str) -> T:
    """Return the value of the condition as soon as it is true. Fail if it is not by the deadline."""
    until = monotonic() + DEADLINE
    while not (found := condition()):
        assert monotonic() < until, f"{what}: still not so after {DEADLINE:g} s"
        sleep(0.01)
    return found
