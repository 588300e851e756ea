"""What functions send goes back to CAN while they run, in a thread of its own."""

import queue
import time
from collections.abc import Iterable, Iterator
from threading import Thread
from typing import Self

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


class Returning:
    """A context in which what functions send is sent to a bus."""

    def __init__(self, sender: Sender, bus: Bus, *, is_lock_step: bool) -> None:
        self.error: Exception | None = None
        """Why it ended before its time."""
        self._sender = sender
        self._bus = bus
        self._is_lock_step = is_lock_step
        self._queue: queue.SimpleQueue[tuple[int, str, str] | None] = queue.SimpleQueue()
        self._thread = Thread(target=self._run, daemon=True)
        self._time = 0
        self._begin: float | None = None

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._queue.put(None)
        self._thread.join()

    def close(self) -> None:
        """Wait until everything has been sent. Raises what ended it before."""
        self._queue.put(None)
        self._thread.join()
        if self.error is not None:
            raise self.error

    def take(self, moment: int, name: str, text: str) -> None:
        """A value has come; from any thread."""
        self._queue.put((moment, name, text))

    def _run(self) -> None:
        try:
            while self._take_some():
                pass
            self._send(_waiting(self._sender, None))
        except Exception as error:  # noqa: BLE001 - told where the context ends
            self.error = error

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
        if moment > self._time:  # what came together goes together
            self._send(self._sender.due(self._time))
            self._send(_waiting(self._sender, moment))
            self._time = moment
        self._sender.take(name, text)

    def _patience(self) -> float | None:
        """Seconds until something that waits is due; in lock step, time goes on with what comes."""
        due = self._sender.next_time()
        if due is None or self._is_lock_step or self._begin is None:
            return None
        return max(0.0, self._begin + due / 1e9 - time.monotonic())

    def _send(self, frames: Iterable[Frame]) -> None:
        for frame in frames:
            self._bus.send(frame)
