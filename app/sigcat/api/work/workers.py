"""The worker processes of a queue: each does one piece of work after another, and is replaced when it ends."""

import asyncio
import pickle
import socket
import weakref
from collections.abc import Iterable
from contextlib import suppress
from typing import Any

from sigcat.api.work.references import Work
from sigcat.api.work.refusals import WorkFailed
from sigcat.api.work.warm_zygote import Known, WarmZygote, zygote_of_this_process
from sigcat.api.work.worker import Outcome
from sigcat.zygote import LENGTH, write_message


class Workers:
    """As many as work at once. Of one event loop at a time."""

    def __init__(self, memory: int, kind: str = "") -> None:
        self._memory = memory
        self._kind = kind
        self._zygote: WarmZygote = zygote_of_this_process()
        self._idle: list[_Worker] = []
        weakref.finalize(self, _close, self._idle)

    async def warm(
        self, count: int, modules: Iterable[str], values: Iterable[object], rehearsals: Iterable[Work] = ()
    ) -> None:
        """Have so many workers ready that know these modules and values, and what was rehearsed."""
        await self._zygote.warm(modules, values, rehearsals)
        self._idle += [self._forked() for _ in range(count - len(self._idle))]

    async def run(self, work: Work) -> Any:
        """The result, or the exception, of a piece of work. Cancelled, or out of memory, it ends with its process."""
        ready = await self._zygote.ready(work)
        worker = self._idle_one(ready.needs) or self._forked()
        while not ready.needs <= worker.known:  # the zygote was started again meanwhile
            worker.close()
            ready = await self._zygote.ready(work)
            worker = self._forked()
        try:
            await worker.begin(ready.data)
            del ready  # it may be large, and is not needed any more
            outcome = await worker.outcome()
        except BaseException:
            worker.close()
            raise
        if outcome.is_last:
            worker.close()
            self._zygote.learn(outcome.modules)
        else:
            self._idle.append(worker)
        if outcome.error is not None:
            raise outcome.error
        return outcome.result

    def close(self) -> None:
        """End those that have nothing to do."""
        _close(self._idle)

    def _idle_one(self, needs: Known) -> "_Worker | None":
        """A worker that knows enough; those that do not are older than what is asked for now, and not needed again."""
        while self._idle:
            worker = self._idle.pop()
            if needs <= worker.known and worker.is_alive:
                return worker
            worker.close()
        return None

    def _forked(self) -> "_Worker":
        return _Worker(*self._zygote.child(self._kind), self._memory)


class _Worker:
    """A worker process, as the service sees it."""

    def __init__(self, connection: socket.socket, known: Known, memory: int) -> None:
        write_message(connection, str(memory).encode())
        connection.setblocking(False)
        self._connection = connection
        self.known = known

    @property
    def is_alive(self) -> bool:
        """Whether it waits for work."""
        try:
            return bool(self._connection.recv(1, socket.MSG_PEEK))
        except BlockingIOError:
            return True
        except OSError:
            return False

    async def begin(self, work: bytes) -> None:
        """Let it do a piece of work."""
        loop = asyncio.get_running_loop()
        with suppress(ConnectionError):  # the result is reported next
            await loop.sock_sendall(self._connection, LENGTH.pack(len(work)))
            await loop.sock_sendall(self._connection, work)

    async def outcome(self) -> Outcome:
        """Return the outcome of the work. Raises WorkFailed if the process ended over it."""
        try:
            (length,) = LENGTH.unpack(await self._received(LENGTH.size))
            outcome: Outcome = pickle.loads(await self._received(length))  # noqa: S301 - of a process of our own
        except ConnectionError:
            raise WorkFailed from None
        return outcome

    def close(self) -> None:
        """End the process."""
        self._connection.close()

    async def _received(self, size: int) -> bytearray:
        loop, data, filled = asyncio.get_running_loop(), bytearray(size), 0
        while filled < size:
            count = await loop.sock_recv_into(self._connection, memoryview(data)[filled:])
            if not count:
                raise ConnectionResetError
            filled += count
        return data


def _close(workers: list[_Worker]) -> None:
    while workers:
        workers.pop().close()
