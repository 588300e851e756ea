"""Frames of a log or of a bus."""

from typing import Any, NamedTuple

FORMS = (".asc", ".blf", ".log")
"""Endings of logs that can be written: those of Vector, as text and as bytes, and that of candump; each may be packed with gzip."""
_COARSE = 4_000_000
"""Seconds beyond which a double holds no nanoseconds: such times are of a calendar, and logged in microseconds."""


class Frame(NamedTuple):
    """A frame of data."""

    time: int
    """In ns, as the log has it."""
    identifier: int
    is_extended: bool
    data: bytes
    channel: str


class Passed(NamedTuple):
    """Something else of a bus: `error`, or `remote` for a request that has no data."""

    kind: str


def frame_of(message: Any, *, first_channel: int = 0) -> Frame | Passed:
    """A message of python-can as a frame. Channels of Vector's logs begin at 1, and python-can counts them from 0."""
    if message.is_error_frame:
        return Passed("error")
    if message.is_remote_frame:
        return Passed("remote")
    number = message.channel
    channel = "" if number is None else str(number + first_channel if isinstance(number, int) else number)
    return Frame(
        in_nanoseconds(message.timestamp), message.arbitration_id, message.is_extended_id, bytes(message.data), channel
    )


def in_nanoseconds(seconds: float) -> int:
    """A time of python-can, which is a double: the decimal that was logged, as near as a double holds it."""
    return round(seconds * 1e9) if -_COARSE < seconds < _COARSE else round(seconds * 1e6) * 1000
