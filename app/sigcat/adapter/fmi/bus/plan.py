"""Tables of a bus in C: messages, signals and mappings, one after the other, with the numbers that they have there."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.fmi.bus.formula import CFormula, in_c
from sigcat.adapter.fmi.variables import Layout, Variable
from sigcat.integration.fmi.bus import BusMapping, BusMessage, BusSignal, FmuBus


class Message(NamedTuple):
    """A message, with the index of its first signal."""

    of: BusMessage
    first: int


class Signal(NamedTuple):
    """A signal, with the index of its message, and that of the first signal of this message."""

    of: BusSignal
    message: int
    first: int

    @property
    def least(self) -> str:
        """Its smallest value."""
        return "-INFINITY" if self.of.min is None else double(self.of.min)

    @property
    def greatest(self) -> str:
        """Its greatest value."""
        return "INFINITY" if self.of.max is None else double(self.of.max)

    @property
    def step(self) -> str:
        """Distance of two values; 0 of real numbers."""
        return double(0 if self.of.encoding == "real" else abs(self.of.factor))


class MappedVariable(NamedTuple):
    """A signal by its index, and the variable that gets or gives its values."""

    of: BusMapping
    signal: int
    part: int
    """Number of the part of its message that it is sent with: a multiplexer selects one."""
    variable: Variable
    formula: CFormula | None

    @property
    def is_sent(self) -> bool:
        """Whether the FMU sends it."""
        return self.of.direction == "sent"

    @property
    def reference(self) -> int:
        """Value reference of the variable; of one that is sent, the number of the output."""
        return self.variable.owner if self.is_sent else self.of.reference


class BusPlan(NamedTuple):
    """Plan of the tables of a bus."""

    bus: FmuBus
    messages: tuple[Message, ...]
    signals: tuple[Signal, ...]
    mappings: tuple[MappedVariable, ...]


def bus_plan(bus: FmuBus, layout: Layout) -> BusPlan:
    """The tables of a bus."""
    messages: list[Message] = []
    signals: list[Signal] = []
    for number, message in enumerate(bus.messages):
        first = len(signals)
        messages.append(Message(message, first))
        signals += [Signal(each, number, first) for each in message.signals]
    return BusPlan(bus, tuple(messages), tuple(signals), tuple(_mappings(signals, layout)))


def _mappings(signals: Sequence[Signal], layout: Layout) -> Iterator[MappedVariable]:
    parts: dict[tuple[int, tuple[int, ...]], int] = {}
    for index, signal in enumerate(signals):
        own = signal.of.selectors[-1].numbers if signal.of.selectors else ()
        for mapping in signal.of.mappings:
            part = parts.setdefault((signal.message, own), len(parts))
            formula = None if mapping.formula is None else in_c(mapping.formula)
            yield MappedVariable(mapping, index, part, layout.variables[mapping.reference], formula)


def double(number: float) -> str:
    """A number as a double in C."""
    return repr(float(number))
