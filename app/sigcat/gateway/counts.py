"""Counts of every frame and of every value: nothing is skipped without being counted."""

from collections import Counter
from collections.abc import Iterator

from sigcat.limits import LOG_FINDINGS, LOG_IDENTIFIERS


class Counts:
    """Counts of one run, which grow with it; what they hold does not grow with the log."""

    def __init__(self) -> None:
        self.frames = 0
        self.passed: Counter[str] = Counter()
        """Error frames, remote frames, and parts of longer messages."""
        self.unknown: Counter[str] = Counter()
        """Frames of identifiers that the database does not have, by them."""
        self.unmapped = 0
        """Frames of which nothing is mapped."""
        self.decoded = 0
        self.short: Counter[str] = Counter()
        """Frames with less data than their message has, by its name: of these, what is there was taken."""
        self.undefined: Counter[tuple[str, str]] = Counter()
        """Frames of which a part is not defined, by the name of their message and what is not: the rest was taken."""
        self.channels: dict[str, set[str]] = {}
        """Channels that the frames of a message came on, by its name."""
        self.others: Counter[str] = Counter()
        """Frames of other channels than the one that was asked for, by these."""
        self.came: Counter[str] = Counter()
        """Values of mapped signals, by their paths."""
        self.held_back = 0
        """Values that came too early, or did not change."""
        self.unfit: Counter[tuple[str, str]] = Counter()
        """Values that are none of their signal, by its path and why."""
        self.sent = 0
        self.defaults = 0
        """Values that signals have before one comes, among those that were sent."""
        self.late = 0
        """Frames with a time before that of the frame above, which count as of that time."""
        self.first: int | None = None
        self.last: int | None = None

    def count_unknown(self, identifier: str) -> None:
        """A frame that the database does not know."""
        known = identifier in self.unknown or len(self.unknown) < LOG_IDENTIFIERS
        self.unknown[identifier if known else "others"] += 1

    def count_other(self, channel: str) -> None:
        """A frame of another channel than the one that was asked for."""
        self.others[channel if channel in self.others or len(self.others) < _MOST else "others"] += 1

    def count_undefined(self, message: str, what: str) -> None:
        """A frame of which a part is not defined."""
        known = (message, what) in self.undefined or len(self.undefined) < LOG_FINDINGS
        self.undefined[message, what if known else "other values of a multiplexer are not defined either"] += 1

    def add_channel(self, message: str, channel: str) -> None:
        """A frame of a message came on a channel."""
        channels = self.channels.setdefault(message, set())
        if len(channels) < _MOST:
            channels.add(channel)

    @property
    def values(self) -> int:
        """Values of mapped signals."""
        return sum(self.came.values())

    @property
    def seconds(self) -> float:
        """From the first frame to the last one."""
        return 0.0 if self.first is None or self.last is None else (self.last - self.first) / 1e9

    def lines(self) -> Iterator[str]:
        """Return the counts for the user, in a few lines."""
        yield f"{self.frames:,} frames in {self.seconds:,.3f} s: {self.decoded:,} decoded{self._not_decoded()}"
        unfit = sum(self.unfit.values())
        left = f"{self.held_back:,} held back by interval or for being unchanged"
        defaults = f" and {self.defaults:,} defaults" if self.defaults else ""
        yield f"{self.values:,} values of mapped signals: {self.sent - self.defaults:,} sent{defaults}, {left}, {unfit:,} unfit"

    def _not_decoded(self) -> str:
        parts = [
            (self.unmapped, "of messages that nothing maps"),
            (self.unknown.total(), f"with {self._identifiers()}"),
            (sum(self.others.values()), "of other channels"),
            (self.passed["error"], "error"),
            (self.passed["remote"], "remote"),
            (self.passed["transport"], "of the transport protocol"),
        ]
        return "".join(f", {count:,} {what}" for count, what in parts if count)

    def _identifiers(self) -> str:
        """Describe identifiers that the database does not have. Of very many, not all are counted separately."""
        count = len(self.unknown)
        if count == 1:
            return "an identifier that the database does not have"
        return f"{count:,}{' or more' if count > LOG_IDENTIFIERS else ''} identifiers that the database does not have"


_MOST = 20
