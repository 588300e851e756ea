"""Heavy work: a few at once in threads of their own, a bounded queue before them, and an honest 503 beyond it."""

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from http import HTTPStatus
from typing import TypeVar

from starlette.exceptions import HTTPException

Result = TypeVar("Result")
RETRY_SECONDS = 2


class Busy(HTTPException):
    """The service cannot do the work now; the header says when to ask again."""

    def __init__(self, detail: str) -> None:
        super().__init__(HTTPStatus.SERVICE_UNAVAILABLE, detail, headers={"Retry-After": str(RETRY_SECONDS)})


class HeavyWork:
    """Compositions, lints, diffs, exports: the event loop stays free while they run."""

    def __init__(self, at_once: int, waiting: int, seconds: float) -> None:
        self._most = at_once + waiting
        self._seconds = seconds
        self._threads = ThreadPoolExecutor(at_once, "sigcat-heavy")
        self.pending = 0
        """How many are under way or wait. A work whose client was told to come again counts until it ends."""

    async def run(self, work: Callable[[], Result]) -> Result:
        """The result of `work`. Raises Busy if too many wait already, or if it takes too long."""
        if self.pending >= self._most:
            raise Busy("More work waits than the service takes. Ask again later.")
        self.pending += 1
        future = asyncio.get_running_loop().run_in_executor(self._threads, work)
        future.add_done_callback(self._ended)
        try:
            return await asyncio.wait_for(future, self._seconds)
        except TimeoutError:
            raise Busy(f"This took longer than {self._seconds:g} seconds and was given up.") from None

    def _ended(self, _: object) -> None:
        self.pending -= 1
