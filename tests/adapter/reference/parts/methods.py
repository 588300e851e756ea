"""Methods that the function offers and uses (section 12)."""

from dataclasses import dataclass
from enum import Enum, IntEnum
from typing import NamedTuple

from tests.adapter.reference.values.transfer import Transfer
from tests.adapter.reference.values.value import Value, numbers_of


class Argument(NamedTuple):
    """An argument or a result."""

    name: str
    variable: str
    transfer: Transfer

    def holds(self, value: Value) -> bool:
        """Whether every number of an enumeration has a name."""
        numbers = zip(self.transfer.elements, numbers_of(value), strict=True)
        return not any(element.is_outside(number) for element, number in numbers)


@dataclass(frozen=True)
class Method:
    """A method, as it is declared."""

    name: str
    call: str
    """The call that it belongs to."""
    is_offered: bool
    inputs: tuple[Argument, ...] = ()
    outputs: tuple[Argument, ...] = ()
    symbol: str | None = None
    time_out: int | None = None
    """In ns."""
    request_variable: str | None = None
    status_variable: str | None = None


class Reply(Enum):
    """Outcome of a request to the function."""

    OK = "OK"
    EXCLUDED = "EXCLUDED"
    BAD_ARGUMENT = "BAD_ARGUMENT"


class Status(IntEnum):
    """Outcome of a request of the function."""

    IDLE = 0
    PENDING = 1
    DONE = 2
    FAILED = 3
    TIMEOUT = 4


class Answer(NamedTuple):
    """An answer that has come."""

    is_ok: bool
    results: tuple[Value, ...]


@dataclass
class Slot:
    """The one request of a method that can be pending."""

    method: Method
    status: Status = Status.IDLE
    number: int = 0
    arguments: tuple[Value, ...] = ()
    asked: int = 0
    answer: Answer | None = None

    @property
    def is_free(self) -> bool:
        """Whether nothing is pending."""
        return self.status is not Status.PENDING

    def ask(self, arguments: tuple[Value, ...], t: int) -> None:
        """The function asks."""
        self.status, self.number, self.arguments, self.asked = Status.PENDING, self.number + 1, arguments, t

    def receive(self, number: int, answer: Answer) -> None:
        """An answer is received; one without a pending request is dropped."""
        if self.status is Status.PENDING and number == self.number and self.answer is None:
            self.answer = answer

    def evaluate(self, t: int) -> tuple[Value, ...] | None:
        """Take a received answer; return its results, if any."""
        if self.status is not Status.PENDING:
            return None
        answer, self.answer = self.answer, None
        if answer is None:
            is_late = self.method.time_out is not None and t - self.asked > self.method.time_out
            self.status = Status.TIMEOUT if is_late else Status.PENDING
            return None
        is_done = answer.is_ok and self._fits(answer.results)
        self.status = Status.DONE if is_done else Status.FAILED
        return answer.results if is_done else None

    def _fits(self, results: tuple[Value, ...]) -> bool:
        return all(argument.holds(value) for argument, value in zip(self.method.outputs, results, strict=True))
