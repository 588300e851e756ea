"""Values that functions send are returned to CAN while they run, in a separate thread."""

import queue
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from threading import Thread
from typing import Self

from sigcat import codes
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.gateway.bus import Bus
from sigcat.gateway.frames import Frame
from sigcat.gateway.sending import Sender
from sigcat.gateway.trace import Row


def frames_of(rows: Iterable[Row], columns: tuple[str, ...], sender: Sender) -> Iterator[Frame]:
    """The frames of a trace: those that wait for their interval stand between its rows, and after the last one."""
    for row in rows:
        yield from _waiting(sender, row.time)
        for index, text in row.cells.items():
            sender.take(columns[index], text)
        yield from sender.due(row.time)
    yield from _waiting(sender, None)


def _waiting(sender: Sender, until: int | None) -> Iterator[Frame]:
    """Frames that wait and are due before a time; without one all of them."""
    while (due := sender.next_time()) is not None and (until is None or due < until):
        yield from sender.due(due)


_PAUSES = (0.01, 0.1, 0.5)
"""Seconds before a frame is sent again that a bus did not take; a frame is given up after the last of these."""
_MOST_WAITING = 10_000
"""Values that wait to be sent; of more, the oldest are dropped."""


class Returning:
    """A context in which what functions send is sent to a bus.

    An error of the bus is reported at once, and the frame is sent again after a pause. While the bus takes none, each later frame
    is tried once, so that the newest values are sent as soon as it works again.
    """

    def __init__(
        self,
        sender: Sender,
        bus: Bus,
        report: Callable[[str], None],
        *,
        is_lock_step: bool,
        pauses: Sequence[float] = _PAUSES,
    ) -> None:
        self.lost = 0
        """Frames that the bus did not take."""
        self.dropped = 0
        """Values that were dropped since too many waited."""
        self.why = ""
        """The last error of the bus."""
        self._error: Exception | None = None
        self._sender = sender
        self._bus = bus
        self._report = report
        self._pauses = pauses
        self._is_failing = False
        self._is_lock_step = is_lock_step
        self._queue: queue.Queue[tuple[int, str, str] | None] = queue.Queue(_MOST_WAITING)
        self._thread = Thread(target=self._run, daemon=True)
        self._time = 0
        self._begin: float | None = None

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._end()

    def close(self) -> None:
        """Wait until everything has been sent. Raises what ended it before."""
        self._end()
        if self._error is not None:
            raise self._error

    def _end(self) -> None:
        while self._thread.is_alive():
            try:
                self._queue.put(None, timeout=1)
            except queue.Full:
                continue
            self._thread.join()

    def take(self, moment: int, name: str, text: str) -> None:
        """A value has come; from one thread. In lock step it waits for its place, else the oldest value makes room."""
        given = moment, name, text
        while self._error is None:
            try:
                self._queue.put(given, timeout=1) if self._is_lock_step else self._queue.put_nowait(given)
            except queue.Full:
                if not self._is_lock_step:
                    self._drop_oldest()
            else:
                return

    def _drop_oldest(self) -> None:
        try:
            self._queue.get_nowait()
        except queue.Empty:
            return
        if not self.dropped:
            self._report(f"more than {_MOST_WAITING:,} values wait to be sent to CAN: the oldest are dropped")
        self.dropped += 1

    def findings(self, name: str) -> Iterator[Finding]:
        """Return the values that did not reach the bus."""
        if self.lost:
            message = f"{self.lost:,} frames were not sent to CAN: {self.why}."
            yield codes.BUS_UNREACHED.finding(message, name)
        if self.dropped:
            message = (
                f"{self.dropped:,} values were dropped since CAN did not take frames as fast as functions send them."
            )
            yield codes.BUS_UNREACHED.finding(message, name)

    def _run(self) -> None:
        try:
            while self._take_some():
                pass
            self._send(_waiting(self._sender, None))
        except Exception as error:  # noqa: BLE001 — raised where the context ends
            self._error = error
            self._report(f"nothing is sent to CAN any more: {error}")

    def _take_some(self) -> bool:
        """Take what has come, and send what is due; False at the end."""
        batch: list[tuple[int, str, str] | None] = []
        try:
            batch.append(self._queue.get(timeout=self._patience()))
            while not self._queue.empty():
                batch.append(self._queue.get())
        except queue.Empty:
            self._send(self._sender.due(self._sender.next_time() or self._time))
            return True
        for each in batch:
            if each is not None:
                self._take(*each)
        self._send(self._sender.due(self._time))
        return None not in batch

    def _take(self, moment: int, name: str, text: str) -> None:
        self._begin = self._begin or time.monotonic() - moment / 1e9
        if moment > self._time:  # values that were received together are sent together
            self._send(self._sender.due(self._time))
            self._send(_waiting(self._sender, moment))
            self._time = moment
        self._sender.take(name, text)

    def _patience(self) -> float | None:
        """Seconds until a waiting value is due; in lock step, time advances with received rows."""
        due = self._sender.next_time()
        if due is None or self._is_lock_step or self._begin is None:
            return None
        return max(0.0, self._begin + due / 1e9 - time.monotonic())

    def _send(self, frames: Iterable[Frame]) -> None:
        for frame in frames:
            if not self._try(frame, () if self._is_failing else self._pauses):
                self.lost += 1

    def _try(self, frame: Frame, pauses: Sequence[float]) -> bool:
        """Whether the bus takes a frame, at once or after a pause."""
        for pause in (*pauses, None):
            try:
                self._bus.send(frame)
            except UsageError as error:
                if not self._is_failing:
                    self._report(f"{error}; it is tried again")
                self._is_failing, self.why = True, str(error)
            else:
                if self._is_failing:
                    self._report(f"frames are sent to CAN again; {self.lost:,} are lost")
                self._is_failing = False
                return True
            if pause is not None:
                time.sleep(pause)
        return False
