"""Frames of a bus, as they come, with python-can."""

import signal
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from sigcat.catalogue.network.can_database import NEEDED
from sigcat.errors import UsageError
from sigcat.gateway.frames import Frame, Passed, frame_of

_ENDS = (signal.SIGINT, signal.SIGTERM)
_WAIT = 0.2
"""Seconds after which is looked whether the time is over."""


def read_bus(interface: str, channel: str, seconds: float | None) -> Iterator[Frame | Passed]:
    """The frames of a bus: until the time is over, or the process is asked to end. Raises UsageError."""
    bus = _opened(interface, channel)
    end = None if seconds is None else time.monotonic() + seconds
    try:
        with _told_to_end() as told:
            while not told and (end is None or time.monotonic() < end):
                message = bus.recv(_WAIT)
                if message is not None:
                    yield frame_of(message)
    finally:
        bus.shutdown()


@contextmanager
def _told_to_end() -> Iterator[list[int]]:
    """Signals that ask for the end, as they come: what was received until then is written, wherever the process is."""
    told: list[int] = []
    before = {number: signal.signal(number, lambda number, _: told.append(number)) for number in _ENDS}
    try:
        yield told
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _opened(interface: str, channel: str) -> Any:
    try:
        import can
    except ImportError:
        raise UsageError(NEEDED) from None
    try:
        return can.Bus(interface=interface, channel=channel)
    except Exception as error:  # noqa: BLE001 — drivers raise what they like
        raise UsageError(f"{interface}:{channel} cannot be opened: {error}") from None
