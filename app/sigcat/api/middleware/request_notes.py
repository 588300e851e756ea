"""Records of requests: a count in the metrics, and a line in the log."""

from collections.abc import Callable
from random import Random
from typing import NamedTuple

from sigcat.api.middleware.metrics import Metrics

NO_ROUTE = "(none)"
_ids = Random()  # noqa: S311 — an id names a request and keeps no secret; asking the system lets other threads go first


class Note(NamedTuple):
    """A request that was answered. Its route is that of the application, or none: a client must not invent names of series."""

    request_id: str
    method: str
    path: str
    route: str
    status: int
    seconds: float
    client: str
    refused: str = ""
    """Why it did not come as far as the application."""
    trace_id: str = ""
    """The trace of OpenTelemetry, if it is traced."""


class RequestNotes:
    """Counts requests and hands notes of them to the log."""

    def __init__(self, metrics: Metrics) -> None:
        self._metrics = metrics
        self.log: Callable[[Note], None] | None = None
        """Receives each note; a server sets it."""

    def add(self, note: Note) -> None:
        """Note a request. What a client chose is cut: it must not invent long lines."""
        method = note.method[:20]
        self._metrics.count(method, note.route, note.status, note.seconds)
        if self.log is not None:
            self.log(note._replace(method=method, path=note.path[:500], client=note.client[:100]))


def new_request_id() -> str:
    """An id that no other request has."""
    return f"{_ids.getrandbits(64):016x}"
