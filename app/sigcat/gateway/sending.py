"""Values become frames when their mappings say: intervals and unchanged values are heeded here."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain
from types import MappingProxyType

from sigcat import codes
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.network_values import Unfit
from sigcat.catalogue.network.sent_numbers import Outgoing
from sigcat.findings import Finding
from sigcat.gateway.encoding import MessageState, Place, places
from sigcat.gateway.frames import Frame


class _Slot:
    """The state of a place that values of a signal go to."""

    __slots__ = ("number", "place", "sent", "time", "waits")

    def __init__(self, place: Place) -> None:
        self.place = place
        self.number: float | None = None
        self.sent: float | None = None
        self.time: int | None = None
        """When it was sent last."""
        self.waits = False
        """Whether a value has come since."""


class Sender:
    """A run towards CAN, and what it has counted.

    A value that comes before its interval is over waits for that, so that the bus has the last value in the end; of several
    that wait, the last one is sent.
    """

    def __init__(
        self,
        database: CanDatabase,
        outgoing: Sequence[Outgoing],
        defaults: Mapping[str, float | str] = MappingProxyType({}),
    ) -> None:
        self._defaults = defaults
        self.values = self.frames = self.sent = self.held_back = 0
        self.unfit: Counter[tuple[str, str]] = Counter()
        """Values that are none of their signal of the network, by path and why."""
        self.unmapped: Counter[str] = Counter()
        """Values of columns that nothing maps, by these."""
        self._slots = {name: [_Slot(place) for place in found] for name, found in places(database, outgoing).items()}
        self._messages: dict[int, MessageState] = {}

    def take(self, name: str, text: str) -> None:
        """A value has come, as the cell of a trace."""
        slots = self._slots.get(name)
        if slots is None:
            self.unmapped[name] += 1
            return
        for slot in slots:
            self.values += 1
            try:
                number = slot.place.raw(text)
            except Unfit as reason:
                self.unfit[slot.place.outgoing.path, str(reason)] += 1
                continue
            self.held_back += slot.waits
            slot.number, slot.waits = number, True

    def due(self, time: int) -> Iterator[Frame]:
        """The frames that are due at a time, in ns: one of each message, for multiplexed ones one of each part."""
        parts: dict[tuple[int, str], list[_Slot]] = {}
        for slot in self._all_slots():
            if slot.waits and self._is_due(slot, time):
                part = id(slot.place.message), str(slot.place.signal.multiplexer_ids)
                parts.setdefault(part, []).append(slot)
        for (message, _), slots in parts.items():
            state = self._messages.setdefault(message, MessageState(slots[0].place.message, self._defaults))
            for slot in slots:
                assert slot.number is not None
                state.set(slot.place.signal, slot.number)
                slot.time, slot.sent, slot.waits = time, slot.number, False
                self.sent += 1
            self.frames += 1
            yield state.frame(time)

    def _all_slots(self) -> Iterator[_Slot]:
        return chain.from_iterable(self._slots.values())

    def _is_due(self, slot: _Slot, time: int) -> bool:
        mapping = slot.place.mapping
        if mapping.on_change and slot.number == slot.sent:
            slot.waits = False
            self.held_back += 1
            return False
        return slot.time is None or time - slot.time >= mapping.interval

    def next_time(self) -> int | None:
        """When a value that waits is due; None if none does."""
        times = ((slot.time or 0) + slot.place.mapping.interval for slot in self._all_slots() if slot.waits)
        return min(times, default=None)

    def line(self) -> str:
        """Return the messages for the user."""
        left = f"{self.held_back:,} held back by interval or for being unchanged"
        unfit = sum(self.unfit.values())
        return (
            f"{self.values:,} values towards CAN: {self.sent:,} sent in {self.frames:,} frames, {left}, {unfit:,} unfit"
        )

    def findings(self, name: str) -> Iterator[Finding]:
        """Return the values that were not sent, and why."""
        for (path, why), count in self.unfit.items():
            yield codes.FRAME_UNFIT.finding(f"{path}: {count:,} values not sent to CAN, {why}.", name)
        if self.unmapped:
            names = sorted(self.unmapped)
            message = f"Nothing maps to CAN: {', '.join(names[:_MOST])}{' and more' if len(names) > _MOST else ''}."
            yield codes.FRAME_UNFIT.graded("info").finding(
                message, name
            )  # most values that functions send stay with them


_MOST = 20
