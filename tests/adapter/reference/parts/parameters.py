"""Parameters: what they start with, what changes them, and what the function has learned (section 11)."""

from dataclasses import dataclass
from typing import NamedTuple

from tests.adapter.reference.values.transfer import Taken, Transfer
from tests.adapter.reference.values.value import Numbers, Value, numbers_of, value_of


class Parameter(NamedTuple):
    """A parameter of one or more calls."""

    name: str
    variable: str
    calls: tuple[str, ...]
    incoming: Transfer
    outgoing: Transfer
    is_learned: bool
    range_error: str | None = None


@dataclass
class ParameterState:
    """A parameter while the adapter runs."""

    parameter: Parameter
    numbers: Numbers = ()
    """Value that the variable gets."""
    is_outside: bool | None = None

    def __post_init__(self) -> None:
        self.numbers = self.parameter.incoming.init

    @property
    def value(self) -> Value:
        """Return the value that the variable gets."""
        return value_of(self.numbers, is_single=self.parameter.incoming.is_single)

    def taken(self, value: Value) -> Taken:
        """Return the result of a value from outside."""
        return self.parameter.incoming.take(numbers_of(value), self.numbers)

    def take(self, value: Value) -> None:
        """Take a value from outside."""
        self.numbers, self.is_outside = self.taken(value)

    def learned(self, value: Value) -> Value | None:
        """Return the stored value for a value of the function; None if it is outside its limits."""
        taken = self.parameter.outgoing.take(numbers_of(value), ())
        self.is_outside = taken.is_outside
        return None if taken.is_outside else value_of(taken.numbers, is_single=self.parameter.outgoing.is_single)
