"""Commands that build, and the processes of commands: none outlives whoever started it."""

import os
import re
import signal
import subprocess
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Lock
from typing import Any

from sigcat.adapter.files import GeneratedFile

_FIRST_ERROR = re.compile(r"\berror:|\bError at\b|undefined reference|multiple definition", re.IGNORECASE)
"""Words before errors in the output of compilers, linkers and CMake."""
_MOST = 6000
"""Characters of a command's output that are kept."""


class BuildFails(Exception):
    """A command that builds has failed; the text is what it says, from its first error on."""

    @property
    def first_error(self) -> str:
        """The line with the error; CMake has it in the next one."""
        lines = [line.strip() for line in str(self).splitlines() if line.strip()]
        first = next((number for number, line in enumerate(lines) if _FIRST_ERROR.search(line)), len(lines) - 1)
        return " ".join(lines[first : first + 2] if lines[first].endswith(":") else lines[first : first + 1])


class Interrupted(Exception):
    """All commands have been ended, as whoever started them was."""


class Groups:
    """Groups of processes that run, in whichever thread they were started: an interrupt comes to one thread, and ends all of them."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._running: set[int] = set()
        self._is_ended = False

    @contextmanager
    def started(self, command: Sequence[str], **options: Any) -> "Iterator[subprocess.Popen[Any]]":
        """A process that leads its own group, which ends with the context. Raises Interrupted when all are ended meanwhile."""
        with self._lock:
            self._refuse_when_ended()
            process = subprocess.Popen(command, process_group=0, **options)  # noqa: S603 - no shell
            self._running.add(process.pid)
        try:
            yield process
            self._refuse_when_ended()
        finally:
            with self._lock:
                self._running.discard(process.pid)
                _kill(process.pid)
            process.wait()

    def _refuse_when_ended(self) -> None:
        if self._is_ended:
            raise Interrupted

    @contextmanager
    def ended(self) -> Iterator[None]:
        """All of them are killed, and until the context ends nothing is started."""
        with self._lock:
            self._is_ended = True
            for pid in self._running:
                _kill(pid)
        try:
            yield
        finally:
            self._is_ended = False


GROUPS = Groups()


def _kill(group: int) -> None:
    with suppress(ProcessLookupError):
        os.killpg(group, signal.SIGKILL)


def ran(command: Sequence[object], environment: Mapping[str, str] | None = None, folder: Path | None = None) -> str:
    """Return the output of a build command. Raises BuildFails if it fails, or Interrupted; its processes end with this one."""
    words = [str(word) for word in command]
    with GROUPS.started(
        words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
        cwd=folder, text=True, errors="replace",
    ) as process:  # fmt: skip
        told, errors = process.communicate()
    if process.returncode:
        raise BuildFails(f"{' '.join(words)}\n{_from_first_error(told + errors)}")
    return str(told)


def _from_first_error(told: str) -> str:
    """With the line before it, in which compilers name the function; the end of it where no error is found."""
    found = _FIRST_ERROR.search(told)
    if found is None:
        return told[-_MOST:]
    line = told.rfind("\n", 0, found.start())
    return told[told.rfind("\n", 0, max(line, 0)) + 1 :][:_MOST]


def write(files: Iterable[GeneratedFile], folder: Path) -> None:
    """Write what is not there already: what is, need not be built again."""
    for file in files:
        path = folder / file.name
        if not path.exists() or path.read_bytes() != file.data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(file.data)
