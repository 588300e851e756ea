"""What is kept of each request: a count in the metrics, and a line in the log."""

import logging
from random import Random
from typing import NamedTuple

from sigcat.api.middleware.metrics import Metrics

NO_ROUTE = "(none)"
_LONGEST_METHOD = 20
_LONGEST_PATH = 500
_ids = Random()  # noqa: S311 — an id names a request and keeps no secret; asking the system lets other threads go first
_log = logging.getLogger("sigcat.requests")


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
    """Counts requests and logs them, each line within a bound, whatever a client sends."""

    def __init__(self, metrics: Metrics, *, is_logged: bool) -> None:
        self._metrics = metrics
        self._is_logged = is_logged

    def add(self, note: Note) -> None:
        """Note a request. The log has the line as it is written, a mapping: the formatter makes JSON of it, once."""
        self._metrics.count(note.method, note.route, note.status, note.seconds)
        if self._is_logged:
            line = {
                "request_id": note.request_id, "method": note.method[:_LONGEST_METHOD], "path": note.path[:_LONGEST_PATH],
                "route": note.route, "status": note.status, "ms": round(note.seconds * 1000, 2), "client": note.client,
            }  # fmt: skip
            _log.info({**line, "refused": note.refused} if note.refused else line)


def new_request_id() -> str:
    """An id that no other request has."""
    return f"{_ids.getrandbits(64):016x}"
