"""Values of signals become numbers of messages, and messages frames: the way back to CAN."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.host.shapes import Number
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.mapping import SignalMapping
from sigcat.catalogue.network.markers import with_markers
from sigcat.catalogue.network.network_values import Unfit, Value
from sigcat.catalogue.network.sent_numbers import Outgoing, number_of, raw_of
from sigcat.catalogue.network.signal_limits import limited, names, physical
from sigcat.gateway.frames import Frame
from sigcat.runs.recording import cells

NO_VALUE = "no value of the datatype"


# -- a value ------------------------------------------------------------------------------------------------------


class Place(NamedTuple):
    """Target of the values of a signal: a signal of a message."""

    outgoing: Outgoing
    message: Any
    signal: Any
    mapping: SignalMapping
    """Mapping of the signal, with the markers of this signal of the network."""

    def raw(self, text: str) -> float:
        """The number that is transmitted for a cell of a trace. Raises Unfit."""
        return number_of(self.signal, _value(text, self.outgoing.datatype), self.mapping)


def _value(text: str, datatype: str) -> Value:
    if datatype == "string":
        return text
    try:
        found = cells.value_of(text, Number(datatype))
    except cells.Unfit:
        raise Unfit(NO_VALUE) from None
    assert isinstance(found, bool | int | float)
    return found


# -- a message ----------------------------------------------------------------------------------------------------


def places(database: CanDatabase, outgoing: Sequence[Outgoing]) -> Mapping[str, tuple[Place, ...]]:
    """Return the targets of signals by column: each message that has the signal, unless the mapping names one."""
    messages = {(message.frame_id, message.is_extended_frame): message for message in reversed(database.messages)}
    found: dict[str, list[Place]] = {}
    for each in outgoing:
        for message in reversed(messages.values()):
            if each.mapping.message in (None, message.name):
                for signal in message.signals:
                    if signal.name == each.mapping.signal:
                        found.setdefault(each.name, []).append(_place(each, message, signal))
    return {name: tuple(each) for name, each in found.items()}


def _place(outgoing: Outgoing, message: Any, signal: Any) -> Place:
    mapping = with_markers(
        outgoing.mapping, outgoing.datatype, names(signal),
        lambda raw: limited(signal, physical(signal, raw)) is not None,
    )  # fmt: skip
    return Place(outgoing, message, signal, mapping)


class MessageState:
    """Values of all signals of a message: the last one, else a default, else the start value of the database, else 0."""

    def __init__(self, message: Any, defaults: Mapping[str, float | str]) -> None:
        self._message = message
        self._numbers: dict[str, float] = {signal.name: signal.raw_initial or 0 for signal in message.signals}
        for signal in message.signals:
            if signal.is_multiplexer and signal.raw_initial is None:
                owned = [each.multiplexer_ids for each in message.signals if each.multiplexer_signal == signal.name]
                self._numbers[signal.name] = min((ids[0] for ids in owned if ids), default=0)

        for signal in message.signals:
            if signal.name in defaults:
                self._numbers[signal.name] = raw_of(signal, defaults[signal.name])

    def set(self, signal: Any, number: float) -> None:
        """Give a signal a number, as it is transmitted; its part of a multiplexed message is the one that is sent next."""
        self._numbers[signal.name] = number
        if signal.multiplexer_ids:
            self._numbers[signal.multiplexer_signal] = signal.multiplexer_ids[0]

    def frame(self, time: int) -> Frame:
        """The frame of this moment."""
        message = self._message
        data = bytes(message.encode(self._numbers, scaling=False, padding=False, strict=False))
        return Frame(time, message.frame_id, bool(message.is_extended_frame), data, "")
