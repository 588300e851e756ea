"""Frames become moments: what the mapped signals are at a time. Intervals and unchanged values are heeded here."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.values import Value
from sigcat.findings import Finding
from sigcat.gateway.counts import Counts
from sigcat.gateway.decoding import Decoded, Decoder
from sigcat.gateway.frames import Frame, Passed
from sigcat.gateway.mapped import Mapped

_MOST_LATE = 10**9
"""Frames of several channels may come in another order; a time that is a second before the last one is of another drive."""


class Moment(NamedTuple):
    """What came with a frame."""

    time: int
    """In ns."""
    values: tuple[Decoded, ...]


class _Sent:
    """What was sent last of a signal, and when."""

    __slots__ = ("time", "value")

    def __init__(self) -> None:
        self.time: int | None = None
        self.value: Value | None = None


class Translation:
    """A run of the gateway: what is asked of it, and what it has counted."""

    def __init__(
        self, database: CanDatabase, mapped: Sequence[Mapped], channel: str | None = None, *, is_from_zero: bool = False
    ) -> None:
        self.counts = Counts()
        self.mapped = mapped
        self.findings: list[Finding] = []
        self.channel = channel
        self.is_from_zero = is_from_zero
        self._decoder = Decoder(database, mapped, self.counts)
        self._sent = [_Sent() for _ in mapped]
        self._defaults = tuple(
            Decoded(number, each.default) for number, each in enumerate(mapped) if each.default is not None
        )

    def moments(self, frames: Iterable[Frame | Passed], name: str) -> Iterator[Moment]:
        """The moments of a log; `name` is what findings call it. It ends where the time goes back."""
        counts = self.counts
        for frame in frames:
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
            found = tuple([each for each in self._decoder.values(frame) if self._is_due(each, time)])
            if self._defaults and found:
                found = self._with_defaults(found)
            counts.sent += len(found)
            if found:
                yield Moment(time, found)

    def _with_defaults(self, found: tuple[Decoded, ...]) -> tuple[Decoded, ...]:
        """What came first, and the defaults of all other signals: what they are before they come."""
        came = {each.number for each in found}
        given = tuple(each for each in self._defaults if each.number not in came)
        for each in given:
            self._sent[each.number].value = each.value
        self.counts.defaults += len(given)
        self._defaults = ()
        return (*found, *given)

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

    def _is_due(self, each: Decoded, time: int) -> bool:
        """Whether a value is sent. One that is not is counted.

        The KUKSA CAN provider begins the interval anew with a value that it then does not send since it is unchanged; by
        VSS's profile it begins with what is sent.
        """
        mapping, sent = self.mapped[each.number].mapping, self._sent[each.number]
        is_time = sent.time is None or time - sent.time >= mapping.interval
        is_changed = not mapping.on_change or not _is_same(each.value, sent.value)
        if is_time and (is_changed or not mapping.is_profile):
            sent.time = time
        if is_time and is_changed:
            sent.value = each.value
            return True
        self.counts.held_back += 1
        return False


def _is_same(value: Value, other: Value | None) -> bool:
    """Whether two values are equal; no number is equal to no number."""
    return value == other or (value != value and other != other)  # noqa: PLR0124 — that is what NaN is


def _goes_back(time: int, counts: Counts, name: str) -> Finding:
    assert counts.last is not None
    message = f"Frame {counts.frames:,} is of {time / 1e9:.6f} s, after one of {counts.last / 1e9:.6f} s."
    fix = "It was read up to there. Split the log: each drive is a log of its own."
    return codes.LOG_TIME_GOES_BACK.finding(message, name, fix=fix)
