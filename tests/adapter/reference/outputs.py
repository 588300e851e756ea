"""Outputs of a call: the sent values (sections 2 and 5)."""

from dataclasses import dataclass, field

from tests.adapter.reference.function import Output
from tests.adapter.reference.values.value import Numbers, Value, numbers_of, value_of


@dataclass
class OutputState:
    """An output while the adapter runs."""

    output: Output
    kept: list[Numbers] = field(default_factory=list)
    """Values sent last, for each place."""
    count: int = 1
    """Number of values to send."""
    overflow: bool | None = None
    is_outside: bool | None = None

    def __post_init__(self) -> None:
        transfer = self.output.transfer
        zero = tuple(0 for _ in transfer.elements)
        self.kept = [zero if self.output.queue else transfer.init] * self.output.places
        self.count = 0 if self.output.queue else 1

    def give(self, value: Value, count: int) -> None:
        """The call has given a value, or as many as it says."""
        numbers, size = numbers_of(value), len(self.output.transfer.elements)
        self.count = min(count, self.output.places)
        self.overflow = count > self.output.places
        taken = [
            self.output.transfer.take(numbers[place * size : (place + 1) * size], self.kept[place])
            for place in range(self.count)
        ]
        self.kept[: self.count] = [each.numbers for each in taken]
        self.is_outside = any(each.is_outside for each in taken)

    @property
    def sent(self) -> Value:
        """Return the sent values; of a queue all given values, one after the other."""
        is_single = self.output.transfer.is_single and self.output.queue is None
        numbers = [number for each in self.kept[: self.count] for number in each]
        return value_of(numbers, is_single=is_single)
