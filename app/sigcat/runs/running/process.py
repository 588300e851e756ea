"""The process of a run: what it tells, as it comes, until it ends or is stopped."""

import os
import signal
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from pathlib import Path
from typing import IO

_PIECE = 1 << 16


class Hangs(Exception):
    """The process said nothing for longer than it may."""


class Ended(Exception):
    """The process ended with this status; a negative one is a signal."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


def told(command: Sequence[str], limit: float, errors: Path | None = None) -> Iterator[bytes]:
    """What the process writes, piece by piece; its errors go to a file, or where ours go. Raises Hangs, or Ended if its status is not 0."""
    with _opened(errors) as file, _started(command, file) as process:
        assert process.stdout is not None
        watch = _Watch(process, limit)
        try:
            yield from watch.pieces(process.stdout)
        finally:
            watch.end()
        if watch.has_stopped_it:
            raise Hangs
        if status := process.wait():
            raise Ended(status)


def _opened(path: Path | None) -> "AbstractContextManager[IO[bytes] | None]":
    return nullcontext() if path is None else path.open("wb")


@contextmanager
def _started(command: Sequence[str], errors: IO[bytes] | None) -> "Iterator[subprocess.Popen[bytes]]":
    """A process that ends with the context, and with it those that it began; also if a signal ends this one while it starts."""
    before = _held_back(_ENDING)
    process: subprocess.Popen[bytes] | None = None
    try:
        # it inherits what waits: it is ended by force, and by this process alone
        process = subprocess.Popen(  # noqa: S603
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=errors,
            bufsize=0,
            process_group=_OWN_GROUP,
        )
        _let_through(before)
        yield process
    finally:
        _let_through(before)
        if process is not None:
            _kill(process)
            process.wait()
            assert process.stdout is not None
            process.stdout.close()


_ENDING = {signal.SIGINT, signal.SIGTERM}
_OWN_GROUP = 0 if hasattr(os, "killpg") else None


def _kill(process: "subprocess.Popen[bytes]") -> None:
    """With all processes of its group, where the system has groups; nothing if they have ended."""
    if _OWN_GROUP is None:
        process.kill()
    else:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


def _held_back(numbers: set[signal.Signals]) -> set[int]:
    """Let signals wait, where the system can; those that waited before."""
    return set(signal.pthread_sigmask(signal.SIG_BLOCK, numbers)) if hasattr(signal, "pthread_sigmask") else set()


def _let_through(before: set[int]) -> None:
    """What waits comes now, but for what waited before."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


class _Watch:
    """Stops a process that is waited for too long."""

    def __init__(self, process: "subprocess.Popen[bytes]", limit: float) -> None:
        self.has_stopped_it = False
        self._process, self._limit = process, limit
        self._waiting_since: float | None = None
        self._has_ended = threading.Event()
        self._thread = threading.Thread(target=self._watch, daemon=True)
        self._thread.start()

    def pieces(self, output: IO[bytes]) -> Iterator[bytes]:
        """Everything that is written; only the time of waiting for it counts."""
        while True:
            self._waiting_since = time.monotonic()
            piece = os.read(output.fileno(), _PIECE)
            self._waiting_since = None
            if not piece:
                return
            yield piece

    def end(self) -> None:
        """Watch no longer."""
        self._has_ended.set()
        self._thread.join()

    def _watch(self) -> None:
        while not self._has_ended.wait(min(self._limit / 10, 1.0)):
            since = self._waiting_since
            if since is not None and time.monotonic() - since > self._limit:
                self.has_stopped_it = True
                _kill(self._process)
                return
