"""The zygote of the worker processes: it has the modules, the catalogues and the rules before a worker needs them."""

import asyncio
import itertools
import logging
import pickle
import socket
import weakref
from collections.abc import Iterable, Mapping
from contextlib import suppress
from functools import lru_cache
from threading import Lock, Thread
from typing import NamedTuple

from sigcat.api.work.references import Work, pickled
from sigcat.api.work.worker import Told
from sigcat.zygote import Zygote

_CHILD = "sigcat.api.work.worker"
_log = logging.getLogger("sigcat")

Known = frozenset[int | str]
"""Contents of a process: names of modules, and numbers of values."""


class ReadyWork(NamedTuple):
    """Work as bytes, and what a worker has to know for it: all that are forked from now on do."""

    data: bytes
    needs: Known


class _Started(NamedTuple):
    """A zygote, and the messages that it got: another one has none of them."""

    zygote: Zygote
    known: set[int | str]


class WarmZygote:
    """Starts when it is first needed, and again where it ended."""

    def __init__(self) -> None:
        self._last: _Started | None = None
        self._starting = Lock()
        self._telling = Lock()
        self._numbers: weakref.WeakKeyDictionary[object, int] = weakref.WeakKeyDictionary()
        self._following = itertools.count(1)

    def child(self, kind: str) -> tuple[socket.socket, Known]:
        """Return a connection to a new worker, and what it knows at least."""
        started = self._started()
        known = frozenset(started.known)  # first: a thread may tell more once the worker is forked
        return started.zygote.child(kind), known

    async def ready(self, work: Work) -> ReadyWork:
        """Work that can be done. The zygote gets values that are new to it; the event loop does not wait for that."""
        data, values = pickled(work, self._number_of)
        modules = {work.function.__module__}
        if not self._started().known.issuperset((*modules, *values)):
            await asyncio.to_thread(self._tell, modules, values)
        return ReadyWork(data, frozenset((*modules, *values)))

    async def warm(self, modules: Iterable[str], values: Iterable[object], rehearsals: Iterable[Work] = ()) -> None:
        """Let it have what work is going to need, and do once what each worker would do first."""
        work = [pickled(each, self._number_of) for each in rehearsals]
        numbered = {self._number_of(value): value for value in values}
        await asyncio.to_thread(
            self._tell, modules, {**numbered, **{n: v for each in work for n, v in each.values.items()}}
        )
        if work:
            told = Told(rehearsals=tuple(each.data for each in work))
            await asyncio.to_thread(self._started().zygote.tell, pickle.dumps(told, pickle.HIGHEST_PROTOCOL))

    def learn(self, modules: Iterable[str]) -> None:
        """Have modules that a worker loaded: later workers start with them. Nothing waits for that."""
        if not self._started().known.issuperset(modules):
            asyncio.get_running_loop().run_in_executor(None, self._tell_if_running, tuple(modules))

    def _tell_if_running(self, modules: Iterable[str]) -> None:
        with suppress(OSError):  # it ended: another one starts without them
            self._tell(modules, {})

    def _started(self) -> _Started:
        with self._starting:
            if self._last is None or self._last.zygote.has_ended:
                zygote = Zygote(_CHILD)
                self._last = _Started(zygote, set())
                Thread(target=_log_end, args=(zygote,), name="sigcat-fork-server", daemon=True).start()
            return self._last

    def _tell(self, modules: Iterable[str], values: Mapping[int, object]) -> None:
        with self._telling:  # the zygote has a value that is known
            zygote, known = self._started()
            new = Told(
                tuple(name for name in modules if name not in known),
                {number: value for number, value in values.items() if number not in known},
            )
            if new != Told():
                zygote.tell(pickle.dumps(new, pickle.HIGHEST_PROTOCOL))
                known.update((*new.modules, *new.values))

    def _number_of(self, value: object) -> int:
        if value not in self._numbers:
            self._numbers[value] = next(self._following)
            weakref.finalize(value, self._forget, self._numbers[value]).atexit = False
        return self._numbers[value]

    def _forget(self, number: int) -> None:
        """Nobody holds the value any more."""
        if self._last is not None and number in self._last.known:
            self._last.known.discard(number)
            with suppress(OSError):
                self._last.zygote.tell(pickle.dumps(Told(forgotten=(number,))))


def _log_end(zygote: Zygote) -> None:
    """Wait until a zygote ends, and log it, unless this process ended it."""
    status = zygote.wait()
    if not zygote.is_closed:
        reason = f"killed by signal {-status}" if status < 0 else f"exit status {status}"
        _log.error("the fork server of the workers ended (%s); the next work starts another one", reason)


@lru_cache(maxsize=1)
def zygote_of_this_process() -> WarmZygote:
    """One for all that a process serves."""
    return WarmZygote()
