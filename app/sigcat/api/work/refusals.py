"""Refusals that a client gets whose work was not done."""

from http import HTTPStatus

from starlette.exceptions import HTTPException

RETRY_SECONDS = 2


class Busy(HTTPException):
    """The service cannot do the work now; the header says when to ask again."""

    status = HTTPStatus.SERVICE_UNAVAILABLE

    def __init__(self, detail: str) -> None:
        super().__init__(self.status, detail, headers={"Retry-After": str(RETRY_SECONDS)})


class BeyondShare(Busy):
    """One client has asked for more than its share: for others there is room."""

    status = HTTPStatus.TOO_MANY_REQUESTS


class WorkFailed(HTTPException):
    """The work ended the process in which it was done."""

    def __init__(self) -> None:
        detail = "The process that did the work ended unexpectedly, and another one took its place. Ask for less."
        super().__init__(HTTPStatus.INTERNAL_SERVER_ERROR, detail)
