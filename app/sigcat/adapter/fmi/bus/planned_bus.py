"""The bus of an FMU: the messages of a CAN database that its variables are mapped to."""

import struct
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.adapter.fmi.bus.formula import OPERATIONS, in_c
from sigcat.adapter.fmi.variables import Layout, Variable
from sigcat.adapter.host.connections import Connections, Entry, Exit
from sigcat.adapter.host.shapes import Number
from sigcat.catalogue.network.mapped_signals import Mapped
from sigcat.catalogue.network.mapping import SignalMapping
from sigcat.catalogue.network.markers import with_markers
from sigcat.catalogue.network.network_values import Unfit, Value, value_of
from sigcat.catalogue.network.sent_numbers import Outgoing, held, number_of
from sigcat.catalogue.network.signal_limits import limited, names, network_value, physical
from sigcat.findings import Finding
from sigcat.function.document.text import Text
from sigcat.integration.fmi.bus import (
    MOST_BITS,
    MOST_BYTES,
    REAL_BITS,
    BusMapping,
    BusMessage,
    BusSelector,
    BusSignal,
    BusValue,
    FmuBus,
)
from sigcat.integration.fmi.network import Network
from sigcat.integration.fmi.settings import BusSettings

_REALS = {32: "<f", 64: "<d"}
_WIDEST = 64


class BusResult(NamedTuple):
    """The bus of an FMU, if anything is mapped to it, and what it cannot carry."""

    bus: FmuBus | None
    findings: tuple[Finding, ...]


class _End(NamedTuple):
    """A variable, and the mapping of its signal."""

    reference: int
    variable: Variable
    path: str
    datatype: str
    mapping: SignalMapping
    allowed: frozenset[Any]
    is_sent: bool

    @property
    def symbols(self) -> Mapping[str, int]:
        """Numbers of the values of an enumeration."""
        return dict(self.variable.number.symbols)


def bus_of(connections: Connections, layout: Layout, settings: BusSettings, network: Network) -> BusResult:
    """The bus of an FMU. A signal of several messages is received from each, and sent in each, unless its mapping names one."""
    ends = list(_ends(connections, layout, network))
    messages: list[BusMessage] = []
    findings: list[Finding] = []
    for message in network.database.messages:
        own = [each for each in ends if each.mapping.message in (None, message.name)]
        by_signal = {
            signal.name: [each for each in own if each.mapping.signal == signal.name] for signal in message.signals
        }
        if any(by_signal.values()):
            found = list(_problems(message, by_signal))
            findings += found
            if not found:
                messages.append(_message(message, by_signal))
    if not messages:
        return BusResult(None, tuple(findings))
    bus = FmuBus(name=settings.name, is_replacing=settings.signals == "replaced", messages=tuple(messages))
    return BusResult(bus, tuple(findings))


def _ends(connections: Connections, layout: Layout, network: Network) -> Iterator[_End]:
    for reference, variable in enumerate(layout.variables):
        if variable.causality == "input":
            yield from _of(reference, variable, connections.entries[variable.owner], network.mapped)
        elif variable.causality == "output":
            yield from _of(reference, variable, connections.exits[variable.owner], network.outgoing)


def _of(reference: int, variable: Variable, end: Entry | Exit, mapped: Sequence[Mapped | Outgoing]) -> Iterator[_End]:
    is_sent = variable.causality == "output"
    for each in mapped if isinstance(end.shape, Number) else ():
        if each.path in end.names or each.name in end.names:
            allowed = each.allowed if isinstance(each, Mapped) else frozenset()
            yield _End(reference, variable, each.path, each.datatype, each.mapping, allowed, is_sent)


# -- what a bus cannot carry --------------------------------------------------------------------------------------


def _problems(message: Any, by_signal: Mapping[str, Sequence[_End]]) -> Iterator[Finding]:
    ends = [each for found in by_signal.values() for each in found]
    path = ends[0].path
    if message.protocol == "j1939":
        fix = "Map the signal to a message with one identifier."
        yield _finding(f"{message.name} is a message of J1939, whose identifiers an FMU does not know.", path, fix)
    if message.length > MOST_BYTES:
        fix = "Map the signal to a message of one frame."
        yield _finding(f"{message.name} must have at most {MOST_BYTES} bytes, not {message.length}.", path, fix)
    is_sent = any(each.is_sent for each in ends)
    for signal in message.signals:
        own = by_signal[signal.name]
        name = f"{message.name}.{signal.name}"
        if (_is_used(signal, message, by_signal) and not _is_expressible(signal, is_mapped=bool(own))) or (
            is_sent and signal.length > _WIDEST
        ):
            text = f"{name} must be a whole number of at most {MOST_BITS} bits, or a real number of 32 or 64 bits, within its message."
            yield _finding(text, own[0].path if own else path, "Map the path to another signal.")
        if len({each.is_sent for each in own}) > 1:
            text = f"{name} must be an input or an output of the FMU, not both: {' and '.join(sorted({each.path for each in own}))}."
            yield _finding(text, own[0].path, "Map one of them to another signal.")
        for each in own:
            formula = each.mapping.formula
            if formula is not None and in_c(formula.text) is None:
                text = f"The formula of {name}, {formula.text}, must have only {OPERATIONS}."
                yield _finding(text, each.path, "Write it with these, or convert the values in the function.")


def _is_expressible(signal: Any, *, is_mapped: bool) -> bool:
    if signal.conversion.is_float:
        return signal.length in REAL_BITS
    return int(signal.length) <= (MOST_BITS if is_mapped else _WIDEST)


def _is_used(signal: Any, message: Any, by_signal: Mapping[str, Sequence[_End]]) -> bool:
    """Whether a frame is encoded or decoded with the signal."""
    if any(each.is_sent for found in by_signal.values() for each in found) or by_signal[signal.name]:
        return True
    selected = (each for each in message.signals if any(signal == parent for parent, _ in _parents(each, message)))
    return any(by_signal[each.name] for each in selected)


def _finding(text: str, path: str, fix: str) -> Finding:
    return codes.BUS_UNFIT.finding(text, path=path, fix=fix)


# -- messages and signals -----------------------------------------------------------------------------------------


def _message(message: Any, by_signal: Mapping[str, Sequence[_End]]) -> BusMessage:
    used = [each for each in message.signals if _is_used(each, message, by_signal)]
    return BusMessage(
        name=Text(message.name),
        identifier=message.frame_id,
        is_extended=bool(message.is_extended_frame),
        is_fd=bool(message.is_fd) or message.length > 8,
        length=max(message.length, *(_size(each) for each in used)),
        signals=tuple(_signal(each, message, used, by_signal[each.name]) for each in used),
    )


def _signal(signal: Any, message: Any, used: Sequence[Any], ends: Sequence[_End]) -> BusSignal:
    conversion = signal.conversion
    return BusSignal(
        name=Text(signal.name),
        start=signal.start,
        length=signal.length,
        order="bigEndian" if signal.byte_order == "big_endian" else "littleEndian",
        encoding="real" if conversion.is_float else "signed" if signal.is_signed else "unsigned",
        factor=conversion.scale,
        offset=conversion.offset,
        min=signal.minimum,
        max=signal.maximum,
        initial=_bits(signal, _initial(signal, message)),
        selectors=tuple(
            BusSelector(signal=used.index(parent), numbers=tuple(map(int, child.multiplexer_ids)))
            for parent, child in reversed(list(_parents(signal, message)))
        ),
        mappings=tuple(_mapping(each, signal) for each in ends),
    )


def _parents(signal: Any, message: Any) -> Iterator[tuple[Any, Any]]:
    """The multiplexer of a signal with the signal, then the one that selects this multiplexer."""
    by_name = {each.name: each for each in message.signals}
    while signal.multiplexer_ids and signal.multiplexer_signal in by_name:
        parent = by_name[signal.multiplexer_signal]
        yield parent, signal
        signal = parent


def _size(signal: Any) -> int:
    first = int(signal.start)
    if signal.byte_order == "big_endian":
        first = first // 8 * 8 + 7 - first % 8
    return -(-(first + int(signal.length)) // 8)


def _initial(signal: Any, message: Any) -> float:
    """The number before a value is sent: of a multiplexer the least one, unless the database states another."""
    if signal.raw_initial is not None:
        return float(signal.raw_initial) if signal.conversion.is_float else int(signal.raw_initial)
    owned = [each.multiplexer_ids for each in message.signals if each.multiplexer_signal == signal.name]
    return int(min((ids[0] for ids in owned if ids), default=0))


def _bits(signal: Any, number: float) -> int:
    if signal.conversion.is_float:
        return int.from_bytes(struct.pack(_REALS[signal.length], number), "little")
    return int(number) & ((1 << int(signal.length)) - 1)


# -- mappings -----------------------------------------------------------------------------------------------------


def _mapping(end: _End, signal: Any) -> BusMapping:
    mapping = with_markers(
        end.mapping, end.datatype, names(signal), lambda raw: limited(signal, physical(signal, raw)) is not None
    )
    is_text = end.datatype == "string"
    values = _sent_values(end, mapping, signal) if end.is_sent else _received_values(end, mapping, signal)
    is_listed = bool(mapping.choices) and (end.is_sent or mapping.formula is None)
    return BusMapping(
        reference=end.reference,
        direction="sent" if end.is_sent else "received",
        interval=mapping.interval,
        counts_attempts=not end.is_sent and not mapping.is_profile,
        on_change=mapping.on_change,
        formula=None if mapping.formula is None else mapping.formula.text,
        values=tuple(values),
        is_listed=is_listed or is_text,
        allowed=() if is_text else tuple(sorted(float(each) for each in end.allowed)),
    )


def _received_values(end: _End, mapping: SignalMapping, signal: Any) -> Iterator[BusValue]:
    """The transmitted numbers that have a name or are in a list, with the values that they have by the mapping."""
    known = names(signal)
    listed = [each for choice in mapping.choices for each in (choice.given, choice.meant)]
    numbers = [each for each in (*listed, *mapping.markers) if isinstance(each, int | float)]
    inverse = [round((each - signal.conversion.offset) / signal.conversion.scale) for each in numbers]
    for raw in sorted({*known, *inverse, *(int(each) for each in numbers if each == int(each))}):
        given = network_value(signal, raw, known) if _is_held(signal, raw) else None
        if given is not None:
            yield BusValue(given=raw, meant=_received(end, mapping, given))


def _received(end: _End, mapping: SignalMapping, given: Any) -> float | None:
    try:
        return _number(value_of(given, mapping, end.datatype, end.allowed), end)
    except Unfit:
        return None


def _sent_values(end: _End, mapping: SignalMapping, signal: Any) -> Iterator[BusValue]:
    """The values that have names or are in a list, with the numbers that are transmitted for them."""
    listed = [each for choice in mapping.choices for each in (choice.given, choice.meant)]
    given: list[Value] = (
        list(end.symbols)
        if end.datatype == "string"
        else [each for each in (*listed, *mapping.markers) if not isinstance(each, str)]
    )
    values = {_number(each, end): each for each in given}
    for number, value in values.items():
        if number is not None:
            yield BusValue(given=number, meant=_sent(signal, value, mapping))


def _sent(signal: Any, value: Value, mapping: SignalMapping) -> float | None:
    try:
        return number_of(signal, value, mapping)
    except Unfit:
        return None


def _number(value: Value, end: _End) -> float | None:
    """The number of a value in its variable; None if it has none."""
    return (
        end.symbols.get(value) if isinstance(value, str) else float(value) if isinstance(value, float) else int(value)
    )


def _is_held(signal: Any, number: float) -> bool:
    try:
        held(signal, number)
    except Unfit:
        return False
    return True
