"""Frames are decoded with cantools, and their values brought to the mapped signals."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import repeat
from typing import Any, NamedTuple

from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.markers import with_markers
from sigcat.catalogue.network.signal_limits import limited, names, physical
from sigcat.catalogue.network.values import OUTSIDE, NetworkValue, Unfit, Value, value_of
from sigcat.gateway.counts import Counts
from sigcat.gateway.frames import Frame
from sigcat.gateway.mapped import Mapped
from sigcat.gateway.multiplexed import defined_parts

_KNOWN_VALUES = 4096
"""Numbers of a signal whose values are kept."""


class Decoded(NamedTuple):
    """A value of a mapped signal, by its number among these."""

    number: int
    value: Value


class _Target:
    """A signal of a message, and a signal of the catalogue that gets its values. A number that came before is looked up."""

    def __init__(self, number: int, mapped: Mapped, signal: Any) -> None:
        self.number = number
        self.mapped = mapped
        self._signal = signal
        self._names = names(signal)
        self._mapping = with_markers(
            mapped.mapping, mapped.datatype, self._names, lambda raw: limited(signal, physical(signal, raw)) is not None
        )
        self._known: dict[float, Value | Unfit] = {}

    def value(self, raw: float) -> Value | Unfit:
        """The value of a number as it was transmitted, or why there is none."""
        found = self._known.get(raw)
        if found is None:
            if len(self._known) >= _KNOWN_VALUES:
                self._known.clear()
            found = self._known[raw] = self._value(raw)
        return found

    def _value(self, raw: float) -> Value | Unfit:
        found = physical(self._signal, raw)
        number = limited(self._signal, found)
        name = self._names.get(raw)  # type: ignore[call-overload]  # a float has a name too
        if number is None and name is None:
            return Unfit(OUTSIDE)
        given = NetworkValue(raw, found if number is None else number, name, number is not None)
        try:
            return value_of(given, self._mapping, self.mapped.datatype, self.mapped.allowed)
        except Unfit as reason:
            return reason.with_traceback(None)  # what it was raised in is not kept


class _Plan(NamedTuple):
    """What is taken of a message."""

    message: Any
    targets: Mapping[str, Sequence[_Target]]
    """By the name of the signal."""


class Decoder:
    """Takes the mapped values out of frames, and counts what it does not take."""

    def __init__(self, database: CanDatabase, mapped: Iterable[Mapped], counts: Counts) -> None:
        self.counts = counts
        by_signal: dict[str, list[tuple[int, Mapped]]] = {}
        for number, each in enumerate(mapped):
            by_signal.setdefault(each.mapping.signal, []).append((number, each))
        self._plans = {
            (channel, message.frame_id, bool(message.is_extended_frame)): _Plan(message, _targets(message, by_signal))
            for message, channel in zip(database.messages, database.channels or repeat(""), strict=False)
        }

    def values(self, frame: Frame) -> Iterator[Decoded]:
        """The values of a frame."""
        plan = self._plans.get(("", frame.identifier, frame.is_extended))
        if plan is None:
            plan = self._plans.get((frame.channel, frame.identifier, frame.is_extended))
        if plan is None:
            self.counts.count_unknown(f"{frame.identifier:X}{'x' if frame.is_extended else ''}")
        elif not plan.targets:
            self.counts.unmapped += 1
        else:
            yield from self._of_plan(plan, frame)

    def _of_plan(self, plan: _Plan, frame: Frame) -> Iterator[Decoded]:
        message, counts = plan.message, self.counts
        try:
            raw = _raw_values(message, frame.data, counts)
        except Exception:  # noqa: BLE001 — cantools raises what the bytes make it meet
            counts.undecodable[message.name] += 1
            return
        counts.decoded += 1
        counts.add_channel(message.name, frame.channel)
        if len(frame.data) < message.length:
            counts.short[message.name] += 1
        for name, targets in plan.targets.items():
            if name not in raw:
                continue  # of another multiplexed part, or beyond the end of a short frame
            for target in targets:
                counts.came[target.mapped.path] += 1
                value = target.value(raw[name])
                if isinstance(value, Unfit):
                    counts.unfit[target.mapped.path, str(value)] += 1
                else:
                    yield Decoded(target.number, value)


def _raw_values(message: Any, data: bytes, counts: Counts) -> Mapping[str, float]:
    """The numbers of a frame as they were transmitted, by the names of signals. Raises what cantools does."""
    try:
        found: Mapping[str, float] = message.decode(data, decode_choices=False, scaling=False, allow_truncated=True)
    except Exception:
        if not message.is_multiplexed():
            raise
        found, undefined = defined_parts(message, data)
        for each in undefined:
            counts.count_undefined(message.name, each)
    return found


def _targets(message: Any, by_signal: Mapping[str, Sequence[tuple[int, Mapped]]]) -> Mapping[str, Sequence[_Target]]:
    found: dict[str, list[_Target]] = {}
    for signal in message.signals:
        for number, each in by_signal.get(signal.name, ()):
            if each.mapping.message in (None, message.name):
                found.setdefault(signal.name, []).append(_Target(number, each, signal))
    return found
