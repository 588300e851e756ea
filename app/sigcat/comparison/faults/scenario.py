"""A fault, and the time in which it is watched: what a file of scenarios says, with times in ns."""

from typing import Literal, NamedTuple


class Spoilt(NamedTuple):
    """What comes of a signal from one time on, and before another, comes otherwise; or something comes, too."""

    kind: Literal["value", "dropped", "delayed", "doubled", "sent"]
    signal: str
    start: int
    end: int
    value: str = ""
    """What comes instead, or too."""
    by: int = 0
    """How much later."""


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
