"""The log of requests: a line of JSON for each, written a few times in a second from a thread.

Neither making lines nor a slow disk holds up answers. What is noted when the process ends is written first.
"""

import atexit
import time
from collections import deque
from functools import lru_cache
from json.encoder import encode_basestring_ascii as _text
from threading import Event, Thread
from typing import TextIO

from sigcat.api.json_log import TIME
from sigcat.api.middleware.request_notes import Note

_SECONDS = 0.05
_MOST = 20_000
"""Notes that wait, where nothing can be written; of more, the oldest are left out."""


class RequestLines:
    """Takes notes, and writes them."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._waiting: deque[tuple[float, Note]] = deque(maxlen=_MOST)
        self._ended = Event()
        self._thread = Thread(target=self._run, name="sigcat-log", daemon=True)
        self._thread.start()
        atexit.register(self.end)

    def add(self, note: Note) -> None:
        """Take a note."""
        self._waiting.append((time.time(), note))

    def end(self) -> None:
        """Write what there is, and no more."""
        self._ended.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._ended.wait(_SECONDS):
            self._write()
        self._write()

    def _write(self) -> None:
        lines = [line_of(*self._waiting.popleft()) for _ in range(len(self._waiting))]
        if lines:
            self._stream.write("".join(lines))
            self._stream.flush()


def line_of(seconds: float, note: Note) -> str:
    """The line of a request that was answered at a time."""
    rest = {"refused": note.refused, "trace_id": note.trace_id}
    more = "".join(f', "{name}": {_text(value)}' for name, value in rest.items() if value)
    return (  # `json.dumps` of a dictionary takes three times as long, and the event loop waits for a part of it
        f'{{"time": {_text(_time(int(seconds)))}, "level": "info", "logger": "sigcat.requests", '
        f'"request_id": {_text(note.request_id)}, "method": {_text(note.method)}, "path": {_text(note.path)}, '
        f'"route": {_text(note.route)}, "status": {note.status}, "ms": {note.seconds * 1000:.2f}, '
        f'"client": {_text(note.client)}{more}}}\n'
    )


@lru_cache(2)
def _time(seconds: int) -> str:
    return time.strftime(TIME, time.localtime(seconds))
