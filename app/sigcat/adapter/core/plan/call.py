"""A call of the function: when it is due, and how it is supervised."""

from typing import NamedTuple

from sigcat.adapter.core.plan.interface import Input, Output
from sigcat.function.document.document import Pointer
from sigcat.function.document.text import Text
from sigcat.names import screaming_snake_case


class Alive(NamedTuple):
    """Limits of the alive supervision (section 10)."""

    least: int
    most: int
    window: int
    """In ns."""
    error: str


class Deadline(NamedTuple):
    """Limits of the deadline supervision, in ns."""

    least: int
    most: int
    error: str


class Logical(NamedTuple):
    """A call in the graph of the logical supervision."""

    number: int
    """Number of its checkpoint, from 1."""
    is_initial: bool
    is_final: bool
    previous: tuple[int, ...]
    """Checkpoints that it may follow."""
    error: str | None


class Call(NamedTuple):
    """A step of the function, or its init or terminate (sections 1 and 9)."""

    name: str
    """Last part of its name: `Step`."""
    interface: str
    pointer: Pointer
    symbol: str
    arguments: tuple[str, ...] = ()
    success: int | None = None
    before: tuple[str, ...] = ()
    after: tuple[str, ...] = ()
    description: Text = Text("")
    cycle: int | None = None
    """In ns; None if events trigger it."""
    offset: int = 0
    debounce: int = 0
    priority: int = 0
    previous: tuple[str, ...] = ()
    most_events: int = 1
    """Events that wait at most: more than one if one of its triggers is a queue."""
    events_per_call: int = 1
    """Events for one call: as many as it takes values at once."""
    triggers: frozenset[str] = frozenset()
    """Names of the ports whose values are its events."""
    is_exclusive: bool = False
    """Whether it never runs at the same time as another one."""
    modes: frozenset[str] | None = None
    """Modes in which it does not run."""
    inputs: tuple[Input, ...] = ()
    outputs: tuple[Output, ...] = ()
    overrun_error: str | None = None
    alive: Alive | None = None
    deadline: Deadline | None = None
    logical: Logical | None = None

    @property
    def constant(self) -> str:
        """Last part of its constant: `STEP`."""
        return screaming_snake_case(self.name)
