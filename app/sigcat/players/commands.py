"""Commands that build."""

import os
import signal
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from sigcat.adapter.files import GeneratedFile


class BuildFails(Exception):
    """A command that builds has failed; the text is what it says."""


def ran(command: Sequence[object], environment: Mapping[str, str] | None = None, folder: Path | None = None) -> str:
    """What a command says that builds. Raises BuildFails with the end of it; its processes end with this one."""
    words = [str(word) for word in command]
    process = subprocess.Popen(  # noqa: S603 - no shell
        words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
        cwd=folder, text=True, errors="replace", process_group=0,
    )  # fmt: skip
    try:
        told, errors = process.communicate()
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
    if process.returncode:
        raise BuildFails(f"{' '.join(words)}\n{told[-6000:]}{errors[-3000:]}")
    return told


def write(files: Iterable[GeneratedFile], folder: Path) -> None:
    """Write what is not there already: what is, need not be built again."""
    for file in files:
        path = folder / file.name
        if not path.exists() or path.read_bytes() != file.data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(file.data)
