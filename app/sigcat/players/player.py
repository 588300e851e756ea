"""A player that runs: rows are given to it, what functions send is heard from it."""

import csv
import os
import signal
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from contextlib import suppress
from threading import Event, Thread
from typing import Self

from sigcat.players.program import Mode, Program

Hear = Callable[[int, str, str], None]
"""Takes the time of a value that a function sent, in ns, its name and the value, in a separate thread."""
_LAST_LINES = 8
_CELLS = 3


class PlayerEnded(Exception):
    """The player has ended before all was sent; the text has its last words."""


class Player:
    """A context: it starts with it, and ends with it, however that comes."""

    def __init__(self, program: Program, mode: Mode, takers: Sequence[Hear]) -> None:
        self.unknown: list[str] = []
        """Columns that no function receives."""
        self.sent: int | None = None
        """Values that it has sent, when it has ended well."""
        self.unheard = 0
        """Number of values that were sent while a function's process was down."""
        self._mode = mode
        self._program = program
        self._takers = takers
        self._ready = Event()
        self._words = tempfile.TemporaryFile("w+b")  # noqa: SIM115 - closed by __exit__

    def __enter__(self) -> Self:
        mode, program = self._mode, self._program
        self._process = subprocess.Popen(  # noqa: S603 - no shell
            program.command(mode), env=program.variables(mode), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=self._words, text=True, encoding="utf-8", errors="replace", process_group=0,
        )  # fmt: skip
        self._listener = Thread(target=self._listen, daemon=True)
        self._listener.start()
        return self

    def __exit__(self, *error: object) -> None:
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self._listener.join()
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        self._words.close()

    def begin(self, header: str) -> None:
        """Name the columns; values that are live come when everybody listens. Raises PlayerEnded."""
        self.give(header)
        if self._mode == "live":
            while not self._ready.wait(0.1):
                if self._process.poll() is not None:
                    raise self._ended()

    def give(self, line: str) -> None:
        """Write a row. Raises PlayerEnded."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(line)
            if self._mode == "live" or not self._ready.is_set():
                self._process.stdin.flush()
        except BrokenPipeError:
            raise self._ended() from None

    def finish(self) -> None:
        """Wait until all rows have been sent. Raises PlayerEnded."""
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        self._process.wait()
        self._listener.join()
        if self.sent is None:
            raise self._ended()

    def _listen(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            word, _, rest = line.rstrip("\n").partition(" ")
            if word == "ready":
                self._ready.set()
            elif word == "unknown":
                self.unknown.append(rest)
            elif word == "sent":
                self.sent = int(rest)
            elif word == "unheard":
                self.unheard = int(rest)
            elif line[:1].isdigit():
                cells = next(csv.reader([line]))
                if len(cells) == _CELLS:
                    for take in self._takers:
                        take(int(cells[0]), cells[1], cells[2])

    def _ended(self) -> PlayerEnded:
        status = self._process.wait()
        self._words.seek(0)
        lines = self._words.read()[-4000:].decode("utf-8", "replace").splitlines()
        words = " ".join(line.removeprefix("player: ") for line in lines[-_LAST_LINES:] if line.strip())
        return PlayerEnded(words or f"It ended with status {status}, with no output.")
