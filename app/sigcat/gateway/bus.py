"""Targets of frames: a bus, at their times, or a log. Both by python-can."""

import time
from collections.abc import Iterable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from sigcat.catalogue.network.can_database import NEEDED
from sigcat.errors import UsageError
from sigcat.gateway.frames import FORMS, Frame

_LARGEST_CLASSIC = 8


class Bus:
    """A context that frames are sent in."""

    def __init__(self, target: Any, *, is_log: bool) -> None:
        self.is_log = is_log
        self._target = target
        self._start: float | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._target.stop() if self.is_log else self._target.shutdown()

    def send_at_times(self, frames: Iterable[Frame]) -> None:
        """Frames are sent when their time has come since the first one; to a log at once. Raises UsageError."""
        for frame in frames:
            if not self.is_log:
                start = self._start = self._start or time.monotonic() - frame.time / 1e9
                time.sleep(max(0.0, start + frame.time / 1e9 - time.monotonic()))
            self.send(frame)

    def send(self, frame: Frame) -> None:
        """Send a frame now. Raises UsageError."""
        from can import CanError, Message

        message = Message(
            timestamp=frame.time / 1e9, arbitration_id=frame.identifier, is_extended_id=frame.is_extended,
            data=frame.data, is_fd=len(frame.data) > _LARGEST_CLASSIC, is_rx=False,
        )  # fmt: skip
        try:
            self._target.on_message_received(message) if self.is_log else self._target.send(message)
        except (CanError, OSError) as error:
            raise UsageError(f"a frame cannot be sent: {error}") from None


def open_bus(target: str) -> Bus:
    """A bus, as INTERFACE:CHANNEL, or a log by its ending. Raises UsageError."""
    try:
        import can
    except ImportError:
        raise UsageError(NEEDED) from None
    name = target.lower().removesuffix(".gz")
    interface, _, channel = target.partition(":")
    is_log = name.endswith(FORMS)
    if not is_log and not (interface and channel):
        forms = ", ".join(FORMS)
        raise UsageError(
            f"--send must be INTERFACE:CHANNEL, such as socketcan:can0, or a log ({forms}), not {target!r}"
        )
    try:
        if is_log:
            return Bus(can.Logger(Path(target)), is_log=True)
        return Bus(can.Bus(interface=interface, channel=channel), is_log=False)
    except Exception as error:  # noqa: BLE001 — drivers raise what they like
        raise UsageError(f"{target} cannot be opened: {error}") from None
