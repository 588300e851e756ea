"""Runs one exporter of vss-tools in a separate process: `python -P worker.py`, or a child of a zygote.

Two lines arrive on standard input, or on the connection of the child: the folder that holds all files of the export, and a
JSON object with `format`, `arguments` (of `vspec export FORMAT`), `instances` (by path; put back at the branches after the
expansion), `log` (a file to write, each line a JSON list of level and message), `place` (the current folder), `seconds`
and `memory` (bytes, or 0). The status is that of the process; a child sends it as a line.

What they arrive on stays open as long as the export is needed: when it ends, the folder is removed, and the process
ends. This file imports nothing of ours, so that it runs wherever vss-tools is installed.
"""

import errno
import importlib
import json
import logging
import os
import shutil
import signal
import socket
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import Any, TextIO

import yaml

DONE, REFUSED, NO_SPACE, NO_MEMORY = 0, 1, 3, 4
"""Statuses. The log says why an export is refused."""
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""Errors of a folder in which nothing more can be written."""
_OUT_OF_MEMORY = (MemoryError, SystemError)
"""CPython raises the second where it had no memory left for the first: a function failed, and no error was set."""
_TRIES = 100
"""Number of attempts to remove the folder."""
_GRACE = 5.0
"""Seconds that a child has for ending by itself."""


class _Log(logging.Handler):
    """Writes records as lines of JSON."""

    def __init__(self, file: TextIO) -> None:
        super().__init__()
        self._file = file

    def emit(self, record: logging.LogRecord) -> None:
        self.write(record.levelname, record.getMessage())

    def write(self, level: str, message: str) -> None:
        """Write one line; it is there even if the process ends at once."""
        self._file.write(json.dumps([level, message]) + "\n")
        self._file.flush()


# -- the export ---------------------------------------------------------------------------------------------------


def export(request: dict[str, Any]) -> int:
    """Run the exporter that a request asks for; the status."""
    try:
        with Path(request["log"]).open("w", encoding="utf-8") as file:
            return _logged_export(request, _Log(file))
    except OSError as error:
        if error.errno in FULL:
            return NO_SPACE
        raise


def _logged_export(request: dict[str, Any], log: _Log) -> int:
    try:
        _export(request, log)
    except SystemExit as error:
        return _lack(error) or (REFUSED if error.code else DONE)
    except Exception as error:  # noqa: BLE001 - whatever an exporter raises goes to the log, never to a user as a traceback
        if lack := _lack(error):
            return lack
        message = getattr(error, "message", "") or str(error)
        log.write("CRITICAL", f"{type(error).__name__}: {message}" if message else type(error).__name__)
        return REFUSED
    return DONE


def _lack(error: BaseException | None) -> int | None:
    """The status if an error comes of too little memory, or of a folder in which nothing more can be written."""
    while error is not None:
        number = error.errno if isinstance(error, OSError) else None
        if isinstance(error, _OUT_OF_MEMORY) or number == errno.ENOMEM:
            return NO_MEMORY
        if number in FULL:
            return NO_SPACE
        error = error.__cause__ or error.__context__
    return None


def _export(request: dict[str, Any], log: _Log) -> None:
    exporter = _exporter(request["format"])
    logging.getLogger().handlers = [log]
    if request["instances"]:
        _keep_instances(exporter, request["instances"])
    exporter.cli.main(request["arguments"], prog_name=request["format"], standalone_mode=False)


def _exporter(name: str) -> Any:
    if hasattr(yaml, "CSafeLoader"):
        vars(yaml)["SafeLoader"] = yaml.CSafeLoader  # the same values, many times faster
    return importlib.import_module(f"vss_tools.exporters.{name}")


def _keep_instances(exporter: Any, instances: dict[str, list[Any]]) -> None:
    """Let branches of the expanded tree say which instances they had; vss-tools empties the list."""
    get_trees = exporter.get_trees

    def with_instances(*arguments: Any, **options: Any) -> Any:
        root, types = get_trees(*arguments, **options)
        for node in (root, *root.descendants):
            if node.get_fqn() in instances:
                node.data.instances = instances[node.get_fqn()]
        return root, types

    exporter.get_trees = with_instances


# -- the process --------------------------------------------------------------------------------------------------


class _Asker(threading.Thread):
    """Waits until the export is no longer needed, removes its folder, and ends the process."""

    def __init__(self, descriptor: int, folder: Path) -> None:
        super().__init__(daemon=True)
        self._descriptor = descriptor
        self._folder = folder
        self.has_left = threading.Event()

    def run(self) -> None:
        os.read(self._descriptor, 1)  # not through `sys.stdin`: its lock would still be held when the export is done
        self.has_left.set()
        _remove(self._folder)
        os._exit(REFUSED)


def _bound(seconds: float, memory: int) -> None:
    """Let the system end this process if it does not end in time, and refuse it more memory than that, if it is bounded."""
    if hasattr(signal, "setitimer"):
        signal.setitimer(signal.ITIMER_REAL, seconds + _GRACE)
    status = Path("/proc/self/status")
    if memory and status.is_file():
        import resource

        (held,) = (int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith("VmData:"))
        resource.setrlimit(resource.RLIMIT_DATA, (held * 1024 + memory,) * 2)


def _remove(folder: Path) -> None:
    for _ in range(_TRIES):  # the export may still write into it
        shutil.rmtree(folder, ignore_errors=True)
        if not folder.exists():
            return
        time.sleep(0.05)


def asked_for(descriptor: int) -> tuple[int, _Asker]:
    """Read the two lines, and export; the status, and who asked."""
    with open(descriptor, encoding="utf-8", closefd=False) as lines:
        folder, text = Path(lines.readline().rstrip("\n")), lines.readline()
    if not text:  # given up before it began
        _remove(folder)
        os._exit(REFUSED)
    asker = _Asker(descriptor, folder)
    asker.start()
    request = json.loads(text)
    _bound(request["seconds"], request["memory"])
    os.chdir(request["place"])
    status = export(request)
    if asker.has_left.is_set():  # an export that misses its files must not end the process before they are all removed
        asker.join()
    return status, asker


# -- as the child of a zygote -------------------------------------------------------------------------------------


def keep(_: bytes) -> None:
    """Nothing is kept."""


def prepare(kind: str) -> None:
    """Import the exporter of which the next child is one."""
    sys.modules.setdefault("pyarrow", None)  # type: ignore[arg-type] # pandas would load it, and a process with threads must not fork
    with suppress(Exception):  # the child finds the same, and tells of it
        _exporter(kind)


def serve(connection: socket.socket) -> None:
    """One export."""
    status, asker = asked_for(connection.fileno())
    connection.sendall(f"{status}\n".encode())
    asker.join()


if __name__ == "__main__":
    sys.exit(asked_for(sys.stdin.fileno())[0])
