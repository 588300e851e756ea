"""A fault, and the time in which it is watched: what a file of scenarios says, with times in ns."""

from typing import Literal, NamedTuple


class Spoilt(NamedTuple):
    """A change to a signal during a period: its values are replaced, dropped, delayed or doubled, or one is added."""

    kind: Literal["value", "dropped", "delayed", "doubled", "sent"]
    signal: str
    start: int
    end: int
    value: str = ""
    """Replacement, or additional value."""
    by: int = 0
    """Delay."""


class Slow(NamedTuple):
    """A call takes longer."""

    call: str
    """Its interface: `CoreAcc_Step`."""
    start: int
    end: int
    takes: int


class Killed(NamedTuple):
    """A function is gone from then on."""

    function: str
    at: int


class Scenario(NamedTuple):
    """Faults that belong together."""

    name: str
    title: str
    description: str
    start: int
    end: int
    """From when and until when it is watched."""
    spoilt: tuple[Spoilt, ...] = ()
    slow: tuple[Slow, ...] = ()
    killed: tuple[Killed, ...] = ()
