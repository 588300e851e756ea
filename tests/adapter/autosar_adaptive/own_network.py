"""A network for one test: only loopback, in a separate namespace."""

import os
import queue
import shutil
import signal
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Self

import pytest

_UNSHARE = ("unshare", "--user", "--map-root-user", "--net")
PATIENCE = 60.0
"""Seconds after which what does not come will not come; on a machine that has other work too."""


def _is_possible() -> bool:
    if not all(shutil.which(name) for name in ("unshare", "nsenter", "ip")):
        return False
    return (
        subprocess.run([*_UNSHARE, "ip", "link", "set", "lo", "up"], capture_output=True, check=False).returncode == 0
    )


own_network = pytest.mark.skipif(
    not _is_possible(), reason="a separate network for each test: Linux with unshare, nsenter and ip"
)


class Program:
    """A process in the network: lines go in, lines come out."""

    def __init__(self, process: "subprocess.Popen[str]", errors: Path) -> None:
        self.process = process
        self._errors = errors
        self._queue: queue.Queue[str | None] = queue.Queue()
        self.told: list[str] = []
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self._queue.put(line.rstrip("\n"))
        self._queue.put(None)

    def do(self, *lines: str) -> Self:
        """Give it lines."""
        assert self.process.stdin is not None
        self.process.stdin.write("".join(f"{line}\n" for line in lines))
        self.process.stdin.flush()
        return self

    def tells(self, *expected: str, within: float = PATIENCE) -> Self:
        """It says each of these lines, in this order, whatever it says between them."""
        for line in expected:
            self._await(line, time.monotonic() + within)
        return self

    def tells_in_any_order(self, *expected: str, within: float = PATIENCE) -> Self:
        """It says each of these lines, whichever comes first: the peer or two threads decide."""
        missing, end = set(expected), time.monotonic() + within
        while missing:
            missing.discard(self._next(f"{sorted(missing)}", end))
        return self

    def next_line(self, within: float = PATIENCE) -> str:
        """The next line that it says."""
        try:
            line = self._queue.get(timeout=within)
        except queue.Empty:
            line = None
        assert line is not None, f"It says no more. {self._all()}"
        self.told.append(line)
        return line

    def _await(self, expected: str, end: float) -> None:
        while self._next(repr(expected), end) != expected:
            pass

    def _next(self, expected: str, end: float) -> str:
        try:
            line = self._queue.get(timeout=max(end - time.monotonic(), 0.0))
        except queue.Empty:
            line = None
        assert line is not None, f"It must say {expected}. {self._all()}"
        self.told.append(line)
        return line

    def is_silent(self, within: float) -> bool:
        """Whether it says nothing for a while; else its next line is taken."""
        try:
            return self._queue.get(timeout=within) is None
        except queue.Empty:
            return True

    def says_nothing_more(self, within: float) -> None:
        """It is silent for a while."""
        try:
            line = self._queue.get(timeout=within)
        except queue.Empty:
            return
        raise AssertionError(f"It says {line!r}. {self._all()}")

    def kill(self) -> None:
        """End it as a crash would."""
        self.process.send_signal(signal.SIGKILL)
        self.process.wait(PATIENCE)

    def quit(self) -> None:
        """Let it end; it does so without an error, and a sanitizer has nothing to say."""
        self.do("quit")
        assert self.process.wait(PATIENCE) == 0, self._all()
        assert self.errors == "", self._all()

    @property
    def errors(self) -> str:
        """The lines that it has written as errors."""
        return self._errors.read_text()

    def _all(self) -> str:
        return f"It said {self.told[-40:]}, and as errors: {self.errors}"


class Network:
    """The network, and what runs in it."""

    def __init__(self, holder: int, folder: Path) -> None:
        self._enter = ("nsenter", "--user", "--net", "--preserve-credentials", "--target", str(holder))
        self._folder = folder
        self._programs: list[Program] = []

    def start(self, command: Sequence[str | Path], **environment: str) -> Program:
        """Run a program in it."""
        errors = self._folder / f"errors_{len(self._programs)}.txt"
        with errors.open("w") as file:
            process = subprocess.Popen(
                [*self._enter, *map(str, command)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=file,
                text=True,
                errors="backslashreplace",
                env={**os.environ, **environment},
            )
        program = Program(process, errors)
        self._programs.append(program)
        return program

    def close(self) -> None:
        """End what still runs."""
        for program in self._programs:
            if program.process.poll() is None:
                program.process.kill()
            program.process.wait()


@contextmanager
def network(folder: Path) -> Iterator[Network]:
    """A network for as long as it is used."""
    # The shell keeps the namespace until its input ends.
    holder = subprocess.Popen(
        [*_UNSHARE, "sh", "-c", "ip link set lo up && echo up && cat"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    )
    assert holder.stdout is not None
    assert holder.stdout.readline() == b"up\n"
    made = Network(holder.pid, folder)
    try:
        yield made
    finally:
        made.close()
        holder.communicate()
