"""Work that takes long: a few pieces at once, each in a process that can be ended, and a bounded queue before them."""

import asyncio
from collections.abc import Awaitable, Callable, Hashable, Iterable
from dataclasses import dataclass
from typing import Any, ParamSpec, TypeVar

from sigcat.api.work.quotas import Quota
from sigcat.api.work.references import Work
from sigcat.api.work.refusals import Busy
from sigcat.api.work.turns import Turns, pass_over
from sigcat.api.work.workers import Workers

_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")
_MEBIBYTE = 1024 * 1024


class WorkQueue:
    """Compositions, lints, diffs, exports: the event loop stays free while they are done."""

    def __init__(
        self,
        at_once: int,
        waiting: int,
        *,
        seconds: float,
        memory: int = 256 * _MEBIBYTE,
        share: float = 1.0,
        kind: str = "",
    ) -> None:
        self._kind = kind
        self._at_once = at_once
        self._seconds = seconds
        self._memory = memory
        self._turns = Turns(at_once, waiting, share)
        self._workers = Workers(memory, kind)
        self._shared: dict[Hashable, _SharedWork] = {}

    @property
    def pending(self) -> int:
        """Number of pieces of work that are under way or wait."""
        return self._turns.pending

    def quota_of(self, client: str) -> Quota:
        """The share of a client, named after what the queue does."""
        return self._turns.quota_of(client, self._kind or "work")

    def of(self, client: str) -> "ClientQueue":
        """The queue as a client uses it."""
        return ClientQueue(self, client)

    async def warm(self, modules: Iterable[str], values: Iterable[object], rehearsals: Iterable[Work] = ()) -> None:
        """Have all workers ready, with the modules and values that work is going to need, and with some of it rehearsed."""
        await self._workers.warm(self._at_once, modules, values, rehearsals)

    def refuse_more(self, client: str) -> None:
        """Raises Busy without room for work of a client now."""
        self._turns.refuse_more(client)

    def close(self) -> None:
        """End the workers."""
        self._workers.close()

    async def work(self, client: str, work: Work) -> Any:
        """Its result. Raises Busy without a turn, or if it takes too long or too much memory: then it is ended."""
        try:
            return await self._within_time(self._in_turn(client, lambda: self._workers.run(work)))
        except MemoryError:
            most = self._memory // _MEBIBYTE
            raise Busy(f"The work needed more than {most:,} MiB of memory and was ended. Ask for less.") from None

    async def work_in_thread(self, client: str, work: Work) -> Any:
        """The same in this process, for what has to stay in it: given up, it holds its turn until it ends."""
        function, arguments, options = work
        in_thread = self._turns.to_the_end(client, lambda: asyncio.to_thread(function, *arguments, **options))
        return await self._within_time(in_thread)

    async def work_once(self, client: str, key: Hashable, work: Work) -> Any:
        """The same once for all who ask for it while it is under way. It ends when all of them went away."""
        shared = self._shared.get(key)
        if shared is None:
            shared = self._shared[key] = _SharedWork(asyncio.create_task(self.work(client, work)))
            shared.task.add_done_callback(pass_over)
        shared.askers += 1
        try:
            return await asyncio.shield(shared.task)
        finally:
            shared.askers -= 1
            if not shared.askers:
                del self._shared[key]
                shared.task.cancel()

    async def _in_turn(self, client: str, begin: Callable[[], Awaitable[_Result]]) -> _Result:
        async with self._turns.turn(client):
            return await begin()

    async def _within_time(self, result: Awaitable[_Result]) -> _Result:
        limit = asyncio.timeout(self._seconds)
        try:
            async with limit:
                return await result
        except TimeoutError:
            if not limit.expired():
                raise
            raise Busy(
                f"The work took longer than {self._seconds:g} seconds and was ended. Try again, or ask for less."
            ) from None


@dataclass
class _SharedWork:
    """Work under way, and how many wait for it."""

    task: asyncio.Task[Any]
    askers: int = 0


class ClientQueue:
    """A queue as one client uses it. Functions are those of modules; what they take and give can be pickled."""

    def __init__(self, queue: WorkQueue, client: str) -> None:
        self._queue = queue
        self._client = client

    def refuse_more(self) -> None:
        """Raises Busy without room for work now: before its input is read."""
        self._queue.refuse_more(self._client)

    async def run(
        self,
        function: Callable[_Arguments, _Result],
        *arguments: _Arguments.args,
        **options: _Arguments.kwargs,
    ) -> _Result:
        """Return the function's result from a worker process."""
        result: _Result = await self._queue.work(self._client, Work(function, arguments, options))
        return result

    async def run_once(
        self,
        key: Hashable,
        function: Callable[_Arguments, _Result],
        *arguments: _Arguments.args,
        **options: _Arguments.kwargs,
    ) -> _Result:
        """The same, once for all clients that ask with an equal key meanwhile."""
        result: _Result = await self._queue.work_once(self._client, key, Work(function, arguments, options))
        return result

    async def run_here(
        self,
        function: Callable[_Arguments, _Result],
        *arguments: _Arguments.args,
        **options: _Arguments.kwargs,
    ) -> _Result:
        """Return the function's result from a thread of this process: for work that changes or fills what is hosted."""
        result: _Result = await self._queue.work_in_thread(self._client, Work(function, arguments, options))
        return result
