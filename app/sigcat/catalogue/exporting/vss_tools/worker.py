"""Runs one exporter of vss-tools in a process of its own: `python -P worker.py REQUEST`.

REQUEST is a JSON file with `format`, `arguments` (of `vspec export FORMAT`), `log` (a file to write) and `instances`
(by path; put back at the branches after the expansion). Each line of the log is a JSON list of level and message.
Exit status: 0 exported, 1 refused; the log says why. Standard input stays open as long as somebody wants the export:
when it ends, the folder that contains REQUEST is removed with all beside it, and the process ends.

This script imports nothing of ours, so that it runs wherever vss-tools is installed.
"""

import importlib
import json
import logging
import os
import shutil
import sys
import threading
import time
from pathlib import Path
from typing import Any, TextIO

import yaml

_TRIES = 100
"""How often the folder is removed until it stays away."""


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


def main(request_file: str) -> int:
    """Run the exporter that a request asks for."""
    request: dict[str, Any] = json.loads(Path(request_file).read_text(encoding="utf-8"))
    with Path(request["log"]).open("w", encoding="utf-8") as file:
        log = _Log(file)
        try:
            _export(request, log)
        except SystemExit as error:
            return 1 if error.code else 0
        except Exception as error:  # noqa: BLE001 - whatever an exporter raises goes to the log, never to a user as a traceback
            message = getattr(error, "message", "") or str(error)
            log.write("CRITICAL", f"{type(error).__name__}: {message}" if message else type(error).__name__)
            return 1
    return 0


def _export(request: dict[str, Any], log: _Log) -> None:
    if hasattr(yaml, "CSafeLoader"):
        vars(yaml)["SafeLoader"] = yaml.CSafeLoader  # the same values, many times faster
    exporter = importlib.import_module(f"vss_tools.exporters.{request['format']}")
    logging.getLogger().handlers = [log]
    if request["instances"]:
        _keep_instances(exporter, request["instances"])
    exporter.cli.main(request["arguments"], prog_name=request["format"], standalone_mode=False)


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


def _end_with_parent(folder: Path, ended: threading.Event) -> None:
    """Wait for the end of standard input: the process that asked was killed, and nothing else would clean up."""
    os.read(sys.stdin.fileno(), 1)  # not through `sys.stdin`: its lock would still be held when the export is done
    ended.set()
    for _ in range(_TRIES):  # the export may still write into it
        shutil.rmtree(folder, ignore_errors=True)
        if not folder.exists():
            break
        time.sleep(0.05)
    os._exit(1)


if __name__ == "__main__":
    ended = threading.Event()
    cleaner = threading.Thread(target=_end_with_parent, args=(Path(sys.argv[1]).parent.parent, ended), daemon=True)
    cleaner.start()
    try:
        status = main(sys.argv[1])
    finally:
        if ended.is_set():  # an export that misses its files must not end the process before they are all removed
            cleaner.join()
    sys.exit(status)
