"""The process of a run: its results, piece by piece, until it ends or is stopped.

Results are in a file that both processes map. No descriptor leads to it, so that a function that writes to any of them,
or closes all of them, changes no result. What the process prints is passed on, up to a limit.
"""

import mmap
import os
import signal
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, NamedTuple

_RING_HEAD = 128
"""As in `sigcat_driver.c`: bytes written at 0, bytes taken at 64."""
_RING_BYTES = 1 << 20
_PIECE = 1 << 16
_SHORTEST, _LONGEST = 0.0001, 0.005
"""Seconds between two looks for results."""


class Hangs(Exception):
    """The process reported nothing for longer than it may."""


class PrintsTooMuch(Exception):
    """The process printed more than it may."""


class Damaged(Exception):
    """The process has written over the place of its results."""


class Ended(Exception):
    """The process ended with this status; a negative one is a signal."""

    def __init__(self, status: int) -> None:
        super().__init__(status)
        self.status = status


class Limits(NamedTuple):
    """Limits of a process."""

    seconds: float
    """Without a result."""
    printed: int
    """Bytes."""


class Ring:
    """Results of a process in a file that both map."""

    def __init__(self, path: Path) -> None:
        path.write_bytes(bytes(_RING_HEAD + _RING_BYTES))
        with path.open("r+b") as file:
            self._map = mmap.mmap(file.fileno(), 0)
        self._counts = memoryview(self._map)[:_RING_HEAD].cast("Q")
        self._taken = 0

    def take(self) -> bytes:
        """Take the bytes written since, as far as they are in one place. Raises Damaged."""
        room = self._counts[0] - self._taken
        if not 0 <= room <= _RING_BYTES:
            raise Damaged
        at = self._taken % _RING_BYTES
        size = min(room, _RING_BYTES - at)
        piece = self._map[_RING_HEAD + at : _RING_HEAD + at + size]
        self._taken += len(piece)
        self._counts[8] = self._taken
        return piece

    def close(self) -> None:
        """Unmap the file."""
        self._counts.release()
        self._map.close()


def results(command: Sequence[str], ring: Path, limits: Limits, prints: Path | None = None) -> Iterator[bytes]:
    """Results of a process, piece by piece. It prints to a file, or to our standard error.

    Raises Hangs, PrintsTooMuch, Damaged, or Ended if its status is not 0.
    """
    mapped = Ring(ring)
    try:
        with _started(command) as process:
            assert process.stdout is not None
            printed = _Printed(process.stdout, prints, limits.printed)
            try:
                yield from _pieces(mapped, process, limits.seconds, printed)
                status = process.wait()
            finally:
                _kill(process)
                printed.end()
            if status:
                raise Ended(status)
    finally:
        mapped.close()


def _pieces(ring: Ring, process: "subprocess.Popen[bytes]", limit: float, printed: "_Printed") -> Iterator[bytes]:
    """Everything that is written; only the time of waiting for it counts."""
    since, pause = time.monotonic(), _SHORTEST
    while True:
        has_ended = process.poll() is not None
        if piece := ring.take():
            yield piece
            since, pause = time.monotonic(), _SHORTEST
        elif printed.is_too_much:
            raise PrintsTooMuch
        elif has_ended:
            return
        elif time.monotonic() - since > limit:
            raise Hangs
        else:
            time.sleep(pause)
            pause = min(2 * pause, _LONGEST)


class _Printed:
    """Passes on what a process prints, until it is too much."""

    def __init__(self, source: IO[bytes], path: Path | None, most: int) -> None:
        self.is_too_much = False
        self._source, self._left = source, most
        self._target = os.dup(2) if path is None else os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o666)
        self._thread = threading.Thread(target=self._pass_on, daemon=True)
        self._thread.start()

    def end(self) -> None:
        """Wait for the rest; a process that left the group of the others may keep it open."""
        self._thread.join(1.0)

    def _pass_on(self) -> None:
        try:
            while piece := os.read(self._source.fileno(), _PIECE):
                self._write(piece[: self._left])
                self._left -= len(piece)
                if self._left < 0:
                    self.is_too_much = True
                    return
        finally:
            os.close(self._target)

    def _write(self, piece: bytes) -> None:
        with suppress(OSError):  # its reader has gone
            while piece:
                piece = piece[os.write(self._target, piece) :]


@contextmanager
def _started(command: Sequence[str]) -> "Iterator[subprocess.Popen[bytes]]":
    """A process that ends with the context, and with it those that it began; also if a signal ends this one while it starts."""
    before = _held_back(_ENDING)
    process: subprocess.Popen[bytes] | None = None
    try:
        # it inherits what waits: it is ended by force, and by this process alone
        process = subprocess.Popen(  # noqa: S603
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
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
    """End it with all processes of its group, where the system has groups; nothing if they have ended."""
    if _OWN_GROUP is None:
        process.kill()
    else:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


def _held_back(numbers: set[signal.Signals]) -> set[int]:
    """Let signals wait, where the system can; those that waited before."""
    return set(signal.pthread_sigmask(signal.SIG_BLOCK, numbers)) if hasattr(signal, "pthread_sigmask") else set()


def _let_through(before: set[int]) -> None:
    """Deliver pending signals, except those that were blocked before."""
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
