"""Status of the function: its errors and their causes, safety reactions, modes."""

from typing import NamedTuple

from sigcat.adapter.core.plan.interface import Named
from sigcat.adapter.core.plan.value import WireType


class Cause(NamedTuple):
    """One of the conditions that make an error present."""

    place: str
    """Member of the context that holds its verdict: `Step.in.BrkCylP.time_out`."""
    call: str | None
    """Call that checks it; None where none does."""
    is_late: bool
    """Whether it is known only when the call has ended."""
    is_supervised: bool = False
    verdict: str = ""
    """Its verdict, if that is the same at any time: `PRESENT` or `ABSENT`. It has no place then."""


class Error(NamedTuple):
    """An error of the function (section 6)."""

    named: Named
    wire: WireType
    passed: int
    failed: int
    """Numbers of the two states that are sent."""
    call: str | None
    """The first step that lists it; None: it is never evaluated."""
    calls: tuple[str, ...]
    """Calls that list it."""
    causes: tuple[Cause, ...]
    variable: str | None
    status_variable: str | None
    maturation: int
    """Time in ns."""
    reset: int
    """Time in ns."""
    waits_for_restart: bool
    reset_input: str | None
    """Place of the flag that tells whether its reset condition holds."""
    dependencies: tuple[str, ...]
    """Own errors that it depends on, by their names here."""
    foreign: tuple[str, ...]
    """Errors of others that it depends on, by the names of their ports."""
    occurrence_limit: int
    ignition_limit: int

    @property
    def is_late(self) -> bool:
        """Whether it is evaluated when its call has ended, and not before."""
        return any(cause.is_late and cause.call == self.call for cause in self.causes)

    @property
    def is_supervised(self) -> bool:
        """Whether a supervision is one of its causes."""
        return any(cause.is_supervised for cause in self.causes)


class ForeignError(NamedTuple):
    """An error of another function, which is received."""

    name: str
    comment: str
    wire: WireType


class Reaction(NamedTuple):
    """A safety reaction (section 7)."""

    named: Named
    wire: WireType
    inactive: int
    active: int
    initial: int
    calls: tuple[str, ...]
    errors: tuple[str, ...]
    foreign: tuple[str, ...]
    variable: str | None
    time_out: int | None
    """In ns."""


class ModeValue(NamedTuple):
    """A mode, by the number that is received or sent and that of the code."""

    name: str
    number: int
    code: int


class ModeIn(NamedTuple):
    """The mode that the function has to take (section 8)."""

    named: Named
    wire: WireType
    modes: tuple[ModeValue, ...]
    initial: ModeValue
    variable: str | None
    goes_to_initial: bool
    unknown_error: str | None

    @property
    def cases(self) -> tuple[ModeValue, ...]:
        """Modes with their numbers in the code, the last one for all that remain; none if those numbers are the received ones."""
        if all(each.number == each.code for each in self.modes):
            return ()
        *others, last = self.modes
        while others and others[-1].code == last.code:
            others.pop()
        return (*others, last)


class ModeOut(NamedTuple):
    """The mode that the function is in."""

    named: Named
    wire: WireType
    modes: tuple[ModeValue, ...]
    variable: str

    @property
    def cases(self) -> tuple[ModeValue, ...]:
        """The first mode of each number of the code."""
        return tuple({each.code: each for each in reversed(self.modes)}.values())[::-1]
