"""Interfaces of a call: inputs, outputs, parameters, methods."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.adapter.core.plan.value import Value, WireType
from sigcat.function.document.document import Pointer


class Named(NamedTuple):
    """Names of an interface in the code, and comments for readers."""

    name: str
    """Identifier, unique in the function."""
    comment: str
    """Path in the catalogue and unit: `Vehicle.Speed [km/h]`."""
    pointer: Pointer
    """Pointer into Function JSON."""


class Condition(NamedTuple):
    """A condition of an input that sets the error which a field of Function JSON names."""

    verdict: str
    """Member of the input's state with its verdict; empty if that is the same at any time."""
    needs_time_out: bool = False
    """Whether it is tested only with a time-out."""
    is_of_taken: bool = False
    """Whether it is tested when a value is taken, and not when the call begins."""


CONDITIONS: Mapping[str, Condition] = {
    "timeout_error": Condition("clock.verdict", needs_time_out=True),
    "range_error": Condition("range", is_of_taken=True),
    "e2e_error": Condition("e2e"),
    "absent_error": Condition(""),
}
"""By the fields. Members beside those of time-outs and ranges, and how they are tested: `adapter/core/c/errors/conditions.c.j2`."""


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
    """Name of its receive function and of its received value, one for all calls; empty if the vehicle lacks the signal."""
    variable: str
    value: Value
    errors: Mapping[str, str]
    """Errors that its `CONDITIONS` set, by the fields that name them."""
    is_immediate: bool = False
    time_out: TimeOut | None = None
    queue: Queue | None = None
    names: tuple[str, ...] = ()
    """Names of it in the declaration."""
    is_reset: bool = False
    """Whether an error is reset by it."""

    @property
    def is_absent(self) -> bool:
        """Whether the vehicle does not have the signal: the variable keeps its start value."""
        return not self.port

    @property
    def is_direct(self) -> bool:
        """Whether it is but an assignment: nothing is checked, nothing is late, nothing waits."""
        is_plain = self.time_out is None and self.queue is None and not self.is_reset
        return is_plain and self.value.is_bare and not self.value.is_checked

    @property
    def keeps(self) -> bool:
        """Whether the last good value is kept for the call, beside the one that was received: of a queue, and of an
        enumeration whose unknown numbers nothing replaces."""
        return not self.is_absent and (self.queue is not None or (self.value.is_checked and self.instead == "KEPT"))

    @property
    def instead(self) -> str:
        """Origin of the value if the received one is out of range."""
        if self.value.is_replaced:
            return "REPLACEMENT"
        return "KEPT" if any(leaf.element.names is not None for leaf in self.value.leaves) else "RECEIVED"

    @property
    def has_state(self) -> bool:
        """Whether a call has to know more of it than its value."""
        is_judged = any(CONDITIONS[field].verdict for field in self.errors)
        return self.keeps or self.is_reset or self.time_out is not None or is_judged

    @property
    def tells_of_rejection(self) -> bool:
        """Whether a message that is not accepted sets an error."""
        return "e2e_error" in self.errors

    @property
    def places(self) -> int:
        """Number of values for which the variable has room."""
        return self.queue.values_per_step if self.queue else 1


class Output(NamedTuple):
    """A signal that a call provides."""

    named: Named
    variable: str
    value: Value
    range_error: str | None = None
    queue: Queue | None = None

    @property
    def is_direct(self) -> bool:
        """Whether it is but an assignment."""
        return self.queue is None and self.value.is_bare and not self.value.is_checked

    @property
    def has_state(self) -> bool:
        """Whether its call has a verdict on it."""
        return self.range_error is not None or (self.queue is not None and self.queue.overflow_error is not None)


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
    def pointers(self) -> tuple[Pointer, ...]:
        """Pointers of the inputs that take it."""
        return tuple(item.named.pointer for _, item in self.consumers)

    @property
    def is_kept(self) -> bool:
        """Whether the value itself is kept where it is received, and not in queues alone."""
        return any(item.queue is None for _, item in self.consumers)

    @property
    def is_timed(self) -> bool:
        """Whether the time of its values counts."""
        return any(item.time_out is not None for _, item in self.consumers)

    @property
    def tells_of_rejection(self) -> bool:
        """Whether a message that is not accepted sets an error."""
        return any(item.tells_of_rejection for _, item in self.consumers)

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
