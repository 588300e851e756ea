"""Tables of a bus in C: messages, signals and mappings, one after the other, with the numbers that they have there."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.fmi.bus.formula import CFormula, in_c
from sigcat.adapter.fmi.variables import Layout
from sigcat.function.document.text import Text
from sigcat.integration.fmi.bus import BusMapping, BusMessage, BusSignal, FmuBus


class Message(NamedTuple):
    """A message; its signals are next to each other."""

    name: Text
    identifier: int
    is_extended: bool
    is_fd: bool
    length: int
    first: int
    signals: int


class Selector(NamedTuple):
    """A multiplexer, by its index among all signals, and the numbers that select a signal."""

    signal: int
    numbers: tuple[int, ...]


class Signal(NamedTuple):
    """A signal of a message."""

    number: int
    name: Text
    message: int
    start: int
    length: int
    size: int
    is_big: bool
    encoding: str
    factor: str
    offset: str
    minimum: str
    maximum: str
    step: str
    initial: int
    selectors: tuple[Selector, ...]


class Item(NamedTuple):
    """A number that is converted separately."""

    given: str
    meant: str
    has_value: bool


class MappedVariable(NamedTuple):
    """A signal, and the variable that gets or gives its values."""

    number: int
    name: Text
    signal: int
    is_sent: bool
    variable: int
    """Value reference; of one that is sent, the number of the output."""
    part: int
    type: str
    formula: CFormula | None
    is_listed: bool
    on_change: bool
    is_attempt: bool
    interval: int
    items: tuple[Item, ...]
    allowed: tuple[str, ...]


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
        messages.append(
            Message(
                message.name, message.identifier, message.is_extended, message.is_fd, message.length, first,
                len(message.signals),
            )
        )  # fmt: skip
        signals += [_signal(each, number, first, first + index) for index, each in enumerate(message.signals)]
    return BusPlan(bus, tuple(messages), tuple(signals), tuple(_mappings(bus.messages, layout)))


def _signal(signal: BusSignal, message: int, first: int, index: int) -> Signal:
    return Signal(
        number=index, name=signal.name, message=message, start=signal.first, length=signal.length, size=signal.size,
        is_big=signal.order == "bigEndian", encoding=f"SIGCAT_{signal.encoding.upper()}", factor=_double(signal.factor),
        offset=_double(signal.offset), minimum="-INFINITY" if signal.min is None else _double(signal.min),
        maximum="INFINITY" if signal.max is None else _double(signal.max),
        step="0.0" if signal.encoding == "real" else _double(abs(signal.factor)), initial=signal.initial,
        selectors=tuple(Selector(first + each.signal, each.numbers) for each in signal.selectors),
    )  # fmt: skip


def _mappings(messages: Sequence[BusMessage], layout: Layout) -> Iterator[MappedVariable]:
    parts: dict[tuple[int, tuple[int, ...]], int] = {}
    index = signal_index = 0
    for number, message in enumerate(messages):
        for signal in message.signals:
            own = signal.selectors[-1].numbers if signal.selectors else ()
            for mapping in signal.mappings:
                part = parts.setdefault((number, own), len(parts))
                yield _mapping(mapping, signal, layout, (index, signal_index, part))
                index += 1
            signal_index += 1


def _mapping(mapping: BusMapping, signal: BusSignal, layout: Layout, at: tuple[int, int, int]) -> MappedVariable:
    variable, is_sent = layout.variables[mapping.reference], mapping.direction == "sent"
    index, signal_index, part = at
    return MappedVariable(
        number=index, name=signal.name, signal=signal_index, is_sent=is_sent,
        variable=variable.owner if is_sent else mapping.reference, part=part, type=variable.storage,
        formula=None if mapping.formula is None else in_c(mapping.formula), is_listed=mapping.is_listed,
        on_change=mapping.on_change, is_attempt=mapping.counts_attempts, interval=mapping.interval,
        items=tuple(Item(_double(e.given), _double(e.meant or 0), e.meant is not None) for e in mapping.values),
        allowed=tuple(map(_double, mapping.allowed)),
    )  # fmt: skip


def _double(number: float) -> str:
    return repr(float(number))
