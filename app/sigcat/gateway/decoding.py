"""Mapped values are taken out of frames: the bits of a signal, their number, and what its mapping makes of it.

A number that was received before is looked up. cantools has read the database; its decoder, which decodes every signal of a
message, is what tests compare with.
"""

from collections.abc import Iterable, Mapping, Sequence
from itertools import repeat
from typing import Any, NamedTuple

from sigcat.adapter.host.shapes import Number
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.mapped_signals import Mapped
from sigcat.catalogue.network.markers import with_markers
from sigcat.catalogue.network.network_values import OUTSIDE, Unfit, Value, value_of
from sigcat.catalogue.network.signal_limits import limited, names, network_value, physical
from sigcat.gateway.counts import Counts
from sigcat.gateway.frames import Frame
from sigcat.gateway.j1939 import by_pgn, pgn
from sigcat.gateway.layout import Bits, bits, numbers, width
from sigcat.runs.recording.cells import cell_of

_KNOWN_VALUES = 4096
"""Numbers of a signal whose values are kept."""


class Decoded(NamedTuple):
    """A value of a mapped signal, by its number among these."""

    number: int
    value: Value
    text: str
    """The value as a trace has it."""


class Failed(NamedTuple):
    """A number of a mapped signal that is not a value of it."""

    number: int
    why: str
    is_attempt: bool
    """Whether its mapping was asked; the KUKSA CAN provider drops a number outside of the limits before."""


def decoded(number: int, value: Value, shape: Number) -> Decoded:
    """A value with its text."""
    return Decoded(number, value, str(value) if shape.datatype == "string" else cell_of(value, shape))


class _Target:
    """A signal of a message, and a signal of the catalogue that gets its values."""

    def __init__(self, number: int, mapped: Mapped, signal: Any) -> None:
        self.path = mapped.path
        self.known: dict[int, Decoded | Failed] = {}
        """Values by the bits that they were received as."""
        self._number = number
        self._mapped = mapped
        self._signal = signal
        self._raw = numbers(signal)
        self._shape = Number(mapped.datatype)
        self._names = names(signal)
        self._mapping = with_markers(
            mapped.mapping, mapped.datatype, self._names, lambda raw: limited(signal, physical(signal, raw)) is not None
        )

    def value(self, found: int) -> Decoded | Failed:
        """The value of bits, or why there is none; it is known from now on."""
        if len(self.known) >= _KNOWN_VALUES:
            self.known.clear()
        value = self.known[found] = self._value(self._raw(found))
        return value

    def _value(self, raw: float) -> Decoded | Failed:
        given = network_value(self._signal, raw, self._names)
        if given is None:
            return Failed(self._number, OUTSIDE, is_attempt=False)
        try:
            value = value_of(given, self._mapping, self._mapped.datatype, self._mapped.allowed)
        except Unfit as reason:
            return Failed(self._number, str(reason), is_attempt=True)
        return decoded(self._number, value, self._shape)


class _Part(NamedTuple):
    """A message, or a part of it that a multiplexer selects."""

    targets: Sequence[tuple[bool, int, int, int, str, Mapping[int, Decoded | Failed], _Target]]
    """Signals: their bits, the path of the mapped signal, its known values, and what gives others."""
    multiplexers: Sequence[tuple[str, Bits, Mapping[int, "_Part"]]]


class _Plan:
    """Used signals of a message."""

    def __init__(self, message: Any, targets: Mapping[str, Sequence[_Target]]) -> None:
        self.name: str = message.name
        self.length: int = message.length
        self.width = width(message)
        self.is_mapped = bool(targets)
        self.part = self._part(message.signals, targets, None)
        self.has_big = any(each.byte_order == "big_endian" for each in message.signals)
        self.is_j1939 = message.protocol == "j1939"

    def _part(self, signals: Sequence[Any], targets: Mapping[str, Sequence[_Target]], multiplexer: str | None) -> _Part:
        """The part that a multiplexer selects, of signals of which only its own have it."""
        own = [each for each in signals if each.multiplexer_signal == multiplexer]
        multiplexers = {each.multiplexer_signal for each in signals}
        return _Part(
            [
                (*bits(each, self.width), target.path, target.known, target)
                for each in own for target in targets.get(each.name, ())
            ],
            [
                (each.name, bits(each, self.width), self._selected(each.name, signals, targets))
                for each in own if each.name in multiplexers
            ],
        )  # fmt: skip

    def _selected(
        self, name: str, signals: Sequence[Any], targets: Mapping[str, Sequence[_Target]]
    ) -> Mapping[int, _Part]:
        """The parts of a multiplexer, by its numbers."""
        known = sorted(
            {number for each in signals if each.multiplexer_signal == name for number in each.multiplexer_ids}
        )
        return {
            number: self._part(
                [
                    each for each in signals
                    if each.multiplexer_signal != name or number in each.multiplexer_ids
                ],
                targets, name,
            )
            for number in known
        }  # fmt: skip


class Decoder:
    """Takes the mapped values out of frames, and counts what it does not take."""

    def __init__(
        self, database: CanDatabase, mapped: Iterable[Mapped], counts: Counts, *, is_j1939: bool = False
    ) -> None:
        self.counts = counts
        by_signal: dict[str, list[tuple[int, Mapped]]] = {}
        for number, each in enumerate(mapped):
            by_signal.setdefault(each.mapping.signal, []).append((number, each))
        self._plans = {
            (channel, message.frame_id, bool(message.is_extended_frame)): _Plan(message, _targets(message, by_signal))
            for message, channel in zip(database.messages, database.channels or repeat(""), strict=False)
        }

        self._known: dict[tuple[int, bool, str], _Plan] = {}
        """Messages of identifiers and channels that were received."""
        self._groups = {
            channel: by_pgn(
                (identifier, plan)
                for (of, identifier, is_extended), plan in self._plans.items()
                if is_extended and of == channel and (is_j1939 or plan.is_j1939)
            )
            for channel, _, _ in self._plans
        }
        self.is_j1939 = any(self._groups.values())
        """Whether there are messages that are found by their PGN."""

    def _plan(self, channel: str, identifier: int, *, is_extended: bool) -> _Plan | None:
        """The message of an identifier; of J1939, that of its PGN."""
        for name in ("", channel):
            plan = self._plans.get((name, identifier, is_extended))
            if plan is None and is_extended and self.is_j1939:
                plan = self._groups.get(name, {}).get(pgn(identifier))
            if plan is not None:
                return plan
        return None

    def values(self, frame: Frame) -> Sequence[Decoded | Failed]:
        """The values of a frame, and those that are none."""
        _, identifier, is_extended, data, channel = frame
        counts = self.counts
        plan = self._known.get((identifier, is_extended, channel))
        if plan is None:
            plan = self._plan(channel, identifier, is_extended=is_extended)
            if plan is not None:
                self._known[identifier, is_extended, channel] = plan
                if plan.is_mapped:
                    counts.add_channel(plan.name, channel)
        if plan is None:
            counts.count_unknown(f"{identifier:X}{'x' if is_extended else ''}")
            return ()
        if not plan.is_mapped:
            counts.unmapped += 1
            return ()
        counts.decoded += 1
        size = len(data)
        from_bytes = int.from_bytes
        if size != plan.width:
            if size < plan.length:
                counts.short[plan.name] += 1
            data = data[: plan.width].ljust(plan.width, b"\0")
        words = from_bytes(data, "little"), from_bytes(data, "big") if plan.has_big else 0
        return self._of_part(plan, plan.part, words, size)

    def _of_part(self, plan: _Plan, part: _Part, words: tuple[int, int], size: int) -> list[Decoded | Failed]:
        found: list[Decoded | Failed] = []
        counts = self.counts
        came = counts.came
        for is_big, shift, mask, least, path, known, target in part.targets:
            if size < least:
                continue  # beyond the end of a short frame
            number = words[is_big] >> shift & mask
            value = known.get(number) or target.value(number)
            came[path] += 1
            if value.__class__ is Failed:
                counts.unfit[path, value[1]] += 1
            found.append(value)
        for name, (is_big, shift, mask, least), parts in part.multiplexers:
            if size >= least:
                selected = words[is_big] >> shift & mask
                if selected in parts:
                    found += self._of_part(plan, parts[selected], words, size)
                else:
                    counts.count_undefined(plan.name, _undefined(name, selected, parts))
        return found


def _undefined(name: str, number: int, parts: Iterable[int]) -> str:
    known = sorted(parts)
    return f"multiplexer {name} is {number}; {', '.join(map(str, known))} {'is' if len(known) == 1 else 'are'} defined"


def _targets(message: Any, by_signal: Mapping[str, Sequence[tuple[int, Mapped]]]) -> Mapping[str, Sequence[_Target]]:
    found: dict[str, list[_Target]] = {}
    for signal in message.signals:
        for number, each in by_signal.get(signal.name, ()):
            if each.mapping.message in (None, message.name):
                found.setdefault(signal.name, []).append(_Target(number, each, signal))
    return found
