"""What is kept of each request: a count in the metrics, and a line in the log."""

from collections.abc import Callable
from random import Random
from typing import NamedTuple

from sigcat.api.middleware.metrics import Metrics

NO_ROUTE = "(none)"
_LONGEST_METHOD = 20
_LONGEST_PATH = 500
_ids = Random()  # noqa: S311 — an id names a request and keeps no secret; asking the system lets other threads go first


class Note(NamedTuple):
    """A request that was answered. Its route is that of the application: a client must not invent names of series."""

    request_id: str
    method: str
    path: str
    route: str
    status: int
    seconds: float
    client: str
    refused: str = ""
    """Why it did not come as far as the application."""


class RequestNotes:
    """Counts requests and hands notes of them to the log, each within a bound, whatever a client sends."""

    def __init__(self, metrics: Metrics) -> None:
        self._metrics = metrics
        self.log: Callable[[Note], None] | None = None
        """Where notes go; a server sets it."""

    def add(self, note: Note) -> None:
        """Note a request."""
        self._metrics.count(note.method, note.route, note.status, note.seconds)
        if self.log is not None:
            if len(note.path) > _LONGEST_PATH or len(note.method) > _LONGEST_METHOD:
                note = note._replace(path=note.path[:_LONGEST_PATH], method=note.method[:_LONGEST_METHOD])
            self.log(note)


def new_request_id() -> str:
    """An id that no other request has."""
    return f"{_ids.getrandbits(64):016x}"
