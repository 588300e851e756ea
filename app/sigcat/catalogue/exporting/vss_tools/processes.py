"""The process in which one exporter of vss-tools runs: a fresh one, or, in a service, a child of one that imported it."""

import json
import logging
import socket
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Protocol

from sigcat.catalogue.exporting.vss_tools.worker import DONE, NO_MEMORY, NO_SPACE, REFUSED
from sigcat.zygote import Zygote

_CHILD = "sigcat.catalogue.exporting.vss_tools.worker"
_WORKER = Path(__file__).with_name("worker.py")
_VARIABLES = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
"""Variables that keep imports of vss-tools from starting threads: a process with threads must not be forked."""
_LONGEST_STATUS = 16
_log = logging.getLogger("sigcat")
_zygote: Zygote | None = None


def keep_warm() -> None:
    """From now on, exports of this process and of its children need not import vss-tools again."""
    global _zygote  # noqa: PLW0603 - one for all, as the children find it
    if _zygote is None or _zygote.has_ended:
        if _zygote is not None:
            _log.error("the fork server of exports ended with status %d; another one is started", _zygote.wait())
        _zygote = Zygote(_CHILD, _VARIABLES)


class ExportEnded(Exception):
    """The process ended before it told how the export went; the message says how."""


class ExportProcess(Protocol):
    """The process of one export, which can be asked once."""

    def status(self, request: Mapping[str, Any]) -> int:
        """Return the outcome of the export. Raises TimeoutError after `seconds` of the request, and ExportEnded."""


@contextmanager
def export_process(name: str, folder: Path) -> Iterator[ExportProcess]:
    """A process for the exporter with this name. If this process is killed meanwhile, it removes the folder and ends."""
    process = _forked(name, folder) or _Fresh(folder)
    try:
        yield process
    finally:
        process.close()


def _forked(name: str, folder: Path) -> "_Forked | None":
    """A child of the process that has imported vss-tools, if there is one."""
    if _zygote is None:
        return None
    try:
        return _Forked(_zygote.child(name), folder)
    except ConnectionError:  # it was ended
        return None


class _Forked:
    """A process that has imported vss-tools already."""

    def __init__(self, connection: socket.socket, folder: Path) -> None:
        self._connection = connection
        connection.sendall(f"{folder}\n".encode())

    def status(self, request: Mapping[str, Any]) -> int:
        """Return the outcome of the export."""
        self._connection.settimeout(request["seconds"])
        try:
            self._connection.sendall(f"{json.dumps(request)}\n".encode())
            told = self._connection.recv(_LONGEST_STATUS)
        except ConnectionError:  # it ended before it read all of that
            told = b""
        if not told:
            raise ExportEnded("its process ended")
        return int(told)

    def close(self) -> None:
        """End it."""
        self._connection.close()


class _Fresh:
    """A separate process. `-P`: no file in the current folder can pass for a module."""

    def __init__(self, folder: Path) -> None:
        command = [sys.executable, "-P", "-X", "utf8", str(_WORKER)]
        nowhere = subprocess.DEVNULL
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=nowhere, stderr=nowhere)  # noqa: S603 - our own script
        self._tell(str(folder))

    def status(self, request: Mapping[str, Any]) -> int:
        """Return the outcome of the export."""
        self._tell(json.dumps(request))
        try:
            status = self._process.wait(request["seconds"])
        except subprocess.TimeoutExpired:
            raise TimeoutError from None
        if status not in (DONE, REFUSED, NO_SPACE, NO_MEMORY):
            raise ExportEnded(f"exit status {status}")
        return status

    def close(self) -> None:
        """End it."""
        self._process.kill()
        with suppress(OSError), self._process:  # its standard input is closed last, so that it leaves the folder alone
            pass

    def _tell(self, line: str) -> None:
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):  # it ended, and its status says how
            self._process.stdin.write(f"{line}\n".encode())
            self._process.stdin.flush()
