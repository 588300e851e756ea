"""Frames become moments: what the mapped signals are at a time. Intervals and unchanged values are heeded here."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple, TypeGuard

from sigcat import codes
from sigcat.adapter.host.shapes import Number
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.mapped_signals import Mapped
from sigcat.catalogue.network.mapping import SignalMapping
from sigcat.catalogue.network.network_values import Value
from sigcat.findings import Finding
from sigcat.gateway.counts import Counts
from sigcat.gateway.decoding import Decoded, Decoder, Failed, decoded
from sigcat.gateway.frames import Frame, Passed
from sigcat.gateway.j1939 import assembled

_MOST_LATE = 10**9
"""Frames of several channels may come in another order; a time that is a second before the last one is of another drive."""


class Moment(NamedTuple):
    """Values of a frame."""

    time: int
    """In ns."""
    values: Sequence[Decoded]


class _Sent:
    """The last value of a signal that was sent, and when its interval began."""

    __slots__ = ("interval", "is_kuksa", "on_change", "time", "value")

    def __init__(self, mapping: SignalMapping) -> None:
        self.interval = mapping.interval
        self.on_change = mapping.on_change
        self.is_kuksa = not mapping.is_profile
        self.time: int | None = None
        self.value: Value | None = None


class Translation:
    """A run of the gateway: what is asked of it, and what it has counted."""

    def __init__(
        self,
        database: CanDatabase,
        mapped: Sequence[Mapped],
        channel: str | None = None,
        *,
        is_from_zero: bool = False,
        is_j1939: bool = False,
    ) -> None:
        self.counts = Counts()
        self.mapped = mapped
        self.findings: list[Finding] = []
        self.channel = channel
        self.is_from_zero = is_from_zero
        self._decoder = Decoder(database, mapped, self.counts, is_j1939=is_j1939)
        self._sent = [_Sent(each.mapping) for each in mapped]
        self._defaults = tuple(
            decoded(number, each.default, Number(each.datatype))
            for number, each in enumerate(mapped)
            if each.default is not None
        )

    def moments(self, frames: Iterable[Frame | Passed], name: str) -> Iterator[Moment]:
        """The moments of a log; `name` is what findings call it. It ends where the time goes back."""
        counts, values, is_due = self.counts, self._decoder.values, self._is_due
        for frame in assembled(frames) if self._decoder.is_j1939 else frames:
            counts.frames += 1
            if isinstance(frame, Passed):
                counts.passed[frame.kind] += 1
                continue
            if self.channel is not None and frame.channel != self.channel:
                counts.count_other(frame.channel)
                continue
            time = self._time(frame.time)
            if time is None:
                self.findings.append(_goes_back(frame.time, counts, name))
                return
            found = [each for each in values(frame) if is_due(each, time)]
            if found:
                if self._defaults:
                    found = self._with_defaults(found)
                counts.sent += len(found)
                yield Moment(time, found)

    def _with_defaults(self, found: Sequence[Decoded]) -> list[Decoded]:
        """Return the first values, and the defaults of all other signals."""
        came = {each.number for each in found}
        given = tuple(each for each in self._defaults if each.number not in came)
        for each in given:
            self._sent[each.number].value = each.value
        self.counts.defaults += len(given)
        self._defaults = ()
        return [*found, *given]

    def _time(self, given: int) -> int | None:
        """The time of a frame: not before the last one. None if it is far before it."""
        counts = self.counts
        if counts.first is None or counts.last is None:
            counts.first = counts.last = given
        elif given < counts.last - _MOST_LATE:
            return None
        elif given < counts.last:
            counts.late += 1
        else:
            counts.last = given
        return counts.last - counts.first if self.is_from_zero else counts.last

    def _is_due(self, each: Decoded | Failed, time: int) -> TypeGuard[Decoded]:
        """Whether a value is sent. One that is not is counted.

        The interval of the KUKSA CAN provider begins with each attempt: also with a value that is not sent since it is
        unchanged, and with a number that its mapping makes no value of. That of VSS's profile begins with what is sent.
        """
        sent = self._sent[each.number]
        is_time = sent.time is None or time - sent.time >= sent.interval
        if isinstance(each, Failed):
            if is_time and sent.is_kuksa and each.is_attempt:
                sent.time = time
            return False
        if is_time and (not sent.on_change or not _is_same(each.value, sent.value)):
            sent.time, sent.value = time, each.value
            return True
        if is_time and sent.is_kuksa:
            sent.time = time
        self.counts.held_back += 1
        return False


def _is_same(value: Value, other: Value | None) -> bool:
    """Whether two values are equal; no number is equal to no number."""
    return value == other or (value != value and other != other)  # noqa: PLR0124 — that is what NaN is


def _goes_back(time: int, counts: Counts, name: str) -> Finding:
    assert counts.last is not None
    message = f"Frame {counts.frames:,} is of {time / 1e9:.6f} s, after one of {counts.last / 1e9:.6f} s."
    fix = "It was read up to there. Split the log: each drive needs its own log."
    return codes.LOG_TIME_GOES_BACK.finding(message, name, fix=fix)
