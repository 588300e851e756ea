"""Requests that wait for entries of the log of the registry. None of them holds a thread."""

import asyncio
from collections.abc import Callable

from fastapi import Request
from fastapi.concurrency import run_in_threadpool

from sigcat.errors import SigcatError

_PAUSE = 0.5
"""Seconds between two looks at the log, which other processes write, too."""


class EventWatch:
    """Wakes all requests that wait when the log grows. One task looks at the log, as long as any waits."""

    def __init__(self) -> None:
        self._last = 0
        self._waiting = 0
        self._grown = asyncio.Event()
        self._looking: asyncio.Task[None] | None = None
        self.is_closed = False
        """Whether the service stops: nobody waits any longer."""

    async def wait(self, number: int, last_number: Callable[[], int], seconds: float) -> None:
        """Wait until the log may have an entry behind a number, at most so many seconds."""
        if self._looking is None or self._looking.done():
            self._last, self._grown = 0, asyncio.Event()
            self._looking = asyncio.create_task(self._look(last_number))
        self._waiting += 1
        try:
            async with asyncio.timeout(seconds):
                while self._last <= number and not self._looking.done() and not self.is_closed:
                    await self._grown.wait()
        except TimeoutError:
            return
        finally:
            self._waiting -= 1

    def close(self) -> None:
        """Wake all requests: the service stops."""
        self.is_closed = True
        self._wake()

    async def _look(self, last_number: Callable[[], int]) -> None:
        """Look at the log until no request waits. A database that cannot be used ends it, and the requests report it."""
        try:
            while self._waiting:
                number = await run_in_threadpool(last_number)
                if number != self._last:
                    self._last = number
                    self._wake()
                await asyncio.sleep(_PAUSE)
        except SigcatError:
            return
        finally:
            self._wake()

    def _wake(self) -> None:
        self._grown.set()
        self._grown = asyncio.Event()


def event_watch_of(request: Request) -> EventWatch:
    """The watch of the service."""
    watch: EventWatch = request.app.state.event_watch
    return watch
