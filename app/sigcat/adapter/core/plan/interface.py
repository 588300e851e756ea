"""What a call takes and gives: inputs, outputs, parameters, methods."""

from typing import NamedTuple

from sigcat.adapter.core.plan.value import Value, WireType
from sigcat.function.document.document import Pointer


class Named(NamedTuple):
    """How an interface is called in the code, and what a reader should know of it."""

    name: str
    """Identifier, unique in the function."""
    comment: str
    """Path in the catalogue and unit: `Vehicle.Speed [km/h]`."""
    pointer: Pointer
    """Where it stands in Function JSON."""


class TimeOut(NamedTuple):
    """When a value is late (section 3)."""

    nanoseconds: int
    starts_with_first: bool
    substitute: str
    """`Last`, `Default` or `Init`."""
    recovery: int
    """Values that end it."""


class Queue(NamedTuple):
    """Values that wait (section 2)."""

    length: int
    drops_newest: bool
    values_per_step: int
    count_variable: str | None
    overflow_error: str | None


class Input(NamedTuple):
    """A signal that a call consumes."""

    named: Named
    port: str
    """What its receive function and its place among the received values are called: one for all calls."""
    variable: str
    value: Value
    is_immediate: bool = False
    time_out: TimeOut | None = None
    time_out_error: str | None = None
    range_error: str | None = None
    e2e_error: str | None = None
    queue: Queue | None = None
    names: tuple[str, ...] = ()
    """How the declaration may call it."""
    is_reset: bool = False
    """Whether an error is reset by it."""


class Output(NamedTuple):
    """A signal that a call provides."""

    named: Named
    variable: str
    value: Value
    range_error: str | None = None
    queue: Queue | None = None


class Port(NamedTuple):
    """A signal that is received, for all calls that consume it."""

    name: str
    comment: str
    wire: WireType
    triggers: tuple[str, ...]
    """Calls that it triggers."""
    consumers: tuple[tuple[str, Input], ...] = ()
    """Calls and their inputs."""

    @property
    def tells_of_rejection(self) -> bool:
        """Whether a message that is not accepted sets an error."""
        return any(item.e2e_error for _, item in self.consumers)

    @property
    def tells_of_loss(self) -> bool:
        """Whether a value that is lost sets an error."""
        return any(item.queue and item.queue.overflow_error for _, item in self.consumers)


class Parameter(NamedTuple):
    """A parameter of one or more calls (section 11)."""

    named: Named
    key: str
    variable: str
    value: Value
    """From the catalogue to the code."""
    learned: Value | None
    """From the code to the catalogue, if the function learns it."""
    calls: tuple[str, ...]
    range_error: str | None = None


class Argument(NamedTuple):
    """An argument or result of a method, in the code's datatype."""

    name: str
    variable: str
    value: Value


class Method(NamedTuple):
    """A method that the function offers or uses (section 12)."""

    named: Named
    call: str
    is_offered: bool
    symbol: str | None
    arguments: tuple[Argument, ...]
    results: tuple[Argument, ...]
    time_out: int | None
    request_variable: str | None
    status_variable: str | None
