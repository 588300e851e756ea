"""Turns: a few pieces of work at once, a bounded number that waits, and a share of both for each client."""

import asyncio
from collections import Counter, deque
from collections.abc import AsyncIterator, Callable, Coroutine
from contextlib import asynccontextmanager
from typing import Any, TypeVar

from sigcat.api.work.quotas import Quota
from sigcat.api.work.refusals import BeyondShare, Busy

_Result = TypeVar("_Result")
_Waiting = deque["asyncio.Future[None]"]


def pass_over(done: "asyncio.Task[Any]") -> None:
    """Ignore an exception after all clients have gone: asyncio would log it."""
    if not done.cancelled():
        done.exception()


class Turns:
    """Clients take turns, so that one with much work does not keep others waiting. For one event loop."""

    def __init__(self, at_once: int, waiting: int, share: float) -> None:
        self._at_once = at_once
        self._most = at_once + waiting
        self._at_once_for_one = max(1, int(at_once * share))
        self._most_for_one = max(1, int(self._most * share))
        self._working: Counter[str] = Counter()
        self._waiting: dict[str, _Waiting] = {}
        """By client; whose turn is next comes first."""

    @property
    def pending(self) -> int:
        """Number of pieces of work that are under way or wait."""
        return self._working.total() + sum(map(len, self._waiting.values()))

    @asynccontextmanager
    async def turn(self, client: str) -> AsyncIterator[None]:
        """Wait for the turn of a client, and have it. Raises as `refuse_more` does."""
        self.refuse_more(client)
        await self._begin(client)
        try:
            yield
        finally:
            self._end(client)

    async def to_the_end(self, client: str, begin: Callable[[], Coroutine[Any, Any, _Result]]) -> _Result:
        """Return the result of work that cannot be stopped: cancelled, it keeps its turn until it ends by itself."""
        self.refuse_more(client)
        await self._begin(client)
        task = asyncio.create_task(begin())
        task.add_done_callback(lambda _: self._end(client))
        task.add_done_callback(pass_over)
        return await asyncio.shield(task)

    def quota_of(self, client: str, name: str) -> Quota:
        """The share of a client."""

        def remaining() -> int:
            return min(self._most - self.pending, self._most_for_one - self._pending_of(client))

        return Quota(name, "concurrent-requests", self._most_for_one, remaining)

    def _pending_of(self, client: str) -> int:
        return self._working[client] + len(self._waiting.get(client, ()))

    def refuse_more(self, client: str) -> None:
        """Raises Busy where too many wait, BeyondShare where too many of this client do."""
        if self.pending >= self._most:
            raise Busy("The queue of the service is full. Try again later.")
        if self._pending_of(client) >= self._most_for_one:
            raise BeyondShare(
                f"One client may have {self._most_for_one} requests of this kind under way. Wait for their answers first."
            )

    async def _begin(self, client: str) -> None:
        if self._may_begin(client):
            self._working[client] += 1
            return
        turn = asyncio.get_running_loop().create_future()
        self._waiting.setdefault(client, deque()).append(turn)
        try:
            await turn
        except asyncio.CancelledError:
            self._leave(client, turn)
            raise

    def _may_begin(self, client: str) -> bool:
        return self._working.total() < self._at_once and self._working[client] < self._at_once_for_one

    def _leave(self, client: str, turn: "asyncio.Future[None]") -> None:
        """Give up waiting, or a turn that was given at the same moment."""
        if not turn.cancelled():
            self._end(client)
            return
        waiting = self._waiting.get(client, deque())
        if turn in waiting:
            waiting.remove(turn)
        if not waiting:
            self._waiting.pop(client, None)

    def _end(self, client: str) -> None:
        self._working[client] -= 1
        if not self._working[client]:
            del self._working[client]
        for following in tuple(self._waiting):
            if self._may_begin(following) and (turn := self._next_of(following)):
                self._working[following] += 1
                turn.set_result(None)
                return

    def _next_of(self, client: str) -> "asyncio.Future[None] | None":
        """The first turn that a client still waits for: who gave up may not have left yet."""
        waiting = self._waiting.pop(client)
        while waiting and waiting[0].cancelled():
            waiting.popleft()
        turn = waiting.popleft() if waiting else None
        if waiting:
            self._waiting[client] = waiting  # behind all others
        return turn
