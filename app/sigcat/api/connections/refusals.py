"""Answers to what is not a request: a problem like any other, with an id, a count and a line in the log."""

from collections.abc import Iterable
from http import HTTPStatus

from sigcat.api.answers.problems import MEDIA_TYPE, problem_of
from sigcat.api.middleware.request_notes import NO_ROUTE, Note, RequestNotes, new_request_id

Headers = Iterable[tuple[bytes, bytes]]


class Refused(Exception):
    """A request that is not read, and the status that says why."""

    def __init__(self, status: HTTPStatus, detail: str, headers: Headers = ()) -> None:
        super().__init__(detail)
        self.status = status
        self.detail = detail
        self.headers = headers


class Refusals:
    """Answers what does not come as far as the application."""

    def __init__(self, notes: RequestNotes, root_path: str) -> None:
        self._notes = notes
        self._root_path = root_path

    def answer(self, refused: Refused, path: str, client: str, headers: Headers = ()) -> bytes:
        """The whole answer, after which the connection is closed; `headers` are those of all answers of the server."""
        request_id = new_request_id()
        self._notes.add(Note(request_id, NO_ROUTE, path, NO_ROUTE, refused.status, 0, client, refused.detail))
        problem = problem_of(refused.status, refused.detail)
        address = self._root_path.rstrip("/") + problem.type
        body = problem.model_copy(update={"type": address, "request_id": request_id}).model_dump_json().encode()
        own = (
            (b"content-type", MEDIA_TYPE.encode()), (b"content-length", b"%d" % len(body)), (b"connection", b"close"),
            (b"x-request-id", request_id.encode()),
        )  # fmt: skip
        lines = [b"%b: %b\r\n" % header for header in (*headers, *own, *refused.headers)]
        status = f"HTTP/1.1 {refused.status} {refused.status.phrase}\r\n".encode()
        return b"".join((status, *lines, b"\r\n", body))
