"""Commands that build, and the processes of commands: none outlives whoever started it."""

import os
import signal
import subprocess
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import Lock
from typing import Any

from sigcat.adapter.files import GeneratedFile


class BuildFails(Exception):
    """A command that builds has failed; the text is what it says."""


class Groups:
    """Groups of processes that run, in whichever thread they were started: an interrupt comes to one thread, and ends all of them."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._running: set[int] = set()
        self._is_ended = False

    @contextmanager
    def started(self, command: Sequence[str], **options: Any) -> "Iterator[subprocess.Popen[Any]]":
        """A process that leads a group of its own, which ends with the context. Raises BuildFails once all have been ended."""
        with self._lock:
            if self._is_ended:
                raise BuildFails("It was interrupted.")
            process = subprocess.Popen(command, process_group=0, **options)  # noqa: S603 - no shell
            self._running.add(process.pid)
        try:
            yield process
        finally:
            with self._lock:
                self._running.discard(process.pid)
                _kill(process.pid)
            process.wait()

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
    """What a command says that builds. Raises BuildFails with the end of it; its processes end with this one."""
    words = [str(word) for word in command]
    with GROUPS.started(
        words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
        cwd=folder, text=True, errors="replace",
    ) as process:  # fmt: skip
        told, errors = process.communicate()
    if process.returncode:
        raise BuildFails(f"{' '.join(words)}\n{told[-6000:]}{errors[-3000:]}")
    return str(told)


def write(files: Iterable[GeneratedFile], folder: Path) -> None:
    """Write what is not there already: what is, need not be built again."""
    for file in files:
        path = folder / file.name
        if not path.exists() or path.read_bytes() != file.data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(file.data)
