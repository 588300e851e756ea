"""Inputs of a call: what was received, and what the call sees of it (sections 2, 3 and 5)."""

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass, field

from tests.adapter.reference.parts.time_out import DEFAULT, LAST, Clock, TimeOut
from tests.adapter.reference.values.transfer import Transfer
from tests.adapter.reference.values.value import Numbers, Value, numbers_of, value_of


@dataclass(frozen=True)
class Queue:
    """Behaviour of a queue of values."""

    length: int
    drops_newest: bool = False
    values_per_step: int = 1
    count_variable: str | None = None
    overflow_error: str | None = None


@dataclass(frozen=True)
class Input:
    """A signal or queue that a call consumes."""

    port: str
    """Name under which it is received; empty if the vehicle does not have it."""
    names: tuple[str, ...]
    """Its name and its path."""
    variable: str
    transfer: Transfer
    is_immediate: bool = False
    time_out: TimeOut | None = None
    errors: Mapping[str, str] = field(default_factory=dict)
    """Errors, by the fields that name them."""
    queue: Queue | None = None

    @property
    def places(self) -> int:
        """Number of values that the variable has room for."""
        return self.queue.values_per_step if self.queue else 1


@dataclass
class InputState:
    """An input while the adapter runs."""

    input: Input
    kept: list[Numbers] = field(default_factory=list)
    """Values taken last, for each place of the variable."""
    waiting: deque[Numbers] = field(default_factory=deque)
    count: int = 0
    lost: int = 0
    clock: Clock | None = None
    overflow: bool | None = None
    is_outside: bool | None = None
    is_rejected: bool | None = None
    """Whether its messages are rejected, by the last snapshot."""
    was_rejected: bool | None = None
    """Whether the last message was."""
    rejections: int = 0
    """Since the last snapshot."""
    is_set: bool = False
    """Whether a number that the call saw in its last snapshot is not 0."""

    def __post_init__(self) -> None:
        self.kept = [self.input.transfer.init] * self.input.places
        self.clock = Clock(self.input.time_out) if self.input.time_out else None

    def receive(self, value: Value, t: int) -> None:
        """A value came."""
        self.was_rejected = False
        if self.clock:
            self.clock.receive(t)
        if self.input.queue is None:
            self.waiting = deque([numbers_of(value)])
        else:
            self._append(numbers_of(value), self.input.queue)

    def reject(self) -> None:
        """A message came that is not accepted."""
        self.was_rejected = True
        self.rejections += 1

    def lose(self) -> None:
        """Values were lost before they came."""
        self.lost += 1

    def _append(self, numbers: Numbers, queue: Queue) -> None:
        is_full = len(self.waiting) == queue.length
        self.lost += is_full
        if is_full and queue.drops_newest:
            return
        if is_full:
            self.waiting.popleft()
        self.waiting.append(numbers)

    def evaluate(self, t: int) -> None:
        """Decide whether it is late, whether values were lost, and whether messages were rejected."""
        if self.clock:
            self.clock.evaluate(t)
        if self.input.queue:
            self.overflow, self.lost = self.lost > 0, 0
        self.is_rejected, self.rejections = True if self.rejections else self.was_rejected, 0

    def take(self) -> None:
        """Take received values; without a new one, all stay."""
        places = range(min(self.input.places, len(self.waiting)))
        taken = [self.input.transfer.take(self.waiting.popleft(), self.kept[place]) for place in places]
        for place, each in enumerate(taken):
            self.kept[place] = each.numbers
        if taken:
            self.is_outside = any(each.is_outside for each in taken)
        self.count = 0 if self._is_substituted else len(taken)
        self.is_set = any(number != 0 for number in numbers_of(self.seen))

    @property
    def _is_substituted(self) -> bool:
        clock = self.clock
        return clock is not None and clock.is_expired and clock.limits.substitute != LAST

    @property
    def seen(self) -> Value:
        """Return the values that the call sees."""
        values = self.kept
        if self._is_substituted and self.clock:
            transfer = self.input.transfer
            values = [transfer.default if self.clock.limits.substitute == DEFAULT else transfer.init] * len(self.kept)
        is_single = self.input.transfer.is_single and self.input.places == 1
        return value_of([number for numbers in values for number in numbers], is_single=is_single)

    def verdict(self, field: str) -> bool | None:
        """Return whether what sets the error of a field holds; None while it has not been tested."""
        return {
            "timeout_error": self.clock.verdict if self.clock else None,
            "range_error": self.is_outside,
            "e2e_error": self.is_rejected,
            "absent_error": self.input.port == "",
            "overflow_error": self.overflow,
        }[field]
