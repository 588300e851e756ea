"""Work that takes long: a few at once in threads of their own, a bounded queue before them, and a 503 beyond it."""

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from http import HTTPStatus
from threading import Lock
from typing import TypeVar

from starlette.exceptions import HTTPException

from sigcat.limits import COMPARED_NAMES
from sigcat.names import bounded_proposals

Result = TypeVar("Result")
RETRY_SECONDS = 2


class Busy(HTTPException):
    """The service cannot do the work now; the header says when to ask again."""

    def __init__(self, detail: str) -> None:
        super().__init__(HTTPStatus.SERVICE_UNAVAILABLE, detail, headers={"Retry-After": str(RETRY_SECONDS)})


def _with_few_proposals(work: Callable[[], Result]) -> Result:
    """The result; a hostile text could ask for near names a million times."""
    with bounded_proposals(COMPARED_NAMES):
        return work()


class WorkQueue:
    """Compositions, lints, diffs, exports: the event loop stays free while they run."""

    def __init__(self, at_once: int, waiting: int, seconds: float) -> None:
        self._most = at_once + waiting
        self._seconds = seconds
        self._threads = ThreadPoolExecutor(at_once, "sigcat-heavy")
        self._counting = Lock()
        self.pending = 0
        """How many are under way or wait. Abandoned work counts until it ends."""

    async def run(self, work: Callable[[], Result]) -> Result:
        """The result of `work`. Raises Busy if too many wait already, or if it takes too long."""
        if self.pending >= self._most:
            raise Busy("The queue of the service is full. Try again later.")
        self._count(1)
        future = self._threads.submit(_with_few_proposals, work)
        future.add_done_callback(lambda _: self._count(-1))
        limit = asyncio.timeout(self._seconds)
        try:
            async with limit:
                return await asyncio.wrap_future(future)
        except TimeoutError:
            if not limit.expired():
                raise
            raise Busy(
                f"The work took longer than {self._seconds:g} seconds and was abandoned. Try again, or ask for less."
            ) from None

    def _count(self, change: int) -> None:
        with self._counting:  # an end is counted by the thread in which it comes
            self.pending += change
