"""The library that converts traces and results, compiled for this process."""

import ctypes
import os
import subprocess
from itertools import takewhile
from pathlib import Path

from sigcat.adapter.toolchain import Toolchain
from sigcat.runs.converting.library import SOURCE, loaded

_NAME = "sigcat_convert.dll" if os.name == "nt" else "sigcat_convert.so"


def convert_library(folder: Path, tools: Toolchain) -> ctypes.CDLL | None:
    """The library, built in a folder; None if it cannot be, as with a compiler for another machine."""
    path = folder / _NAME
    compiler = tools.c if tools.is_zig else tuple(takewhile(lambda word: not word.startswith("-"), tools.c))
    command = (*compiler, "-O2", "-shared", "-fPIC", "-fvisibility=hidden", "-o", str(path), str(SOURCE), "-lm")
    done = subprocess.run(command, capture_output=True, check=False)  # noqa: S603 — no shell
    return loaded(path) if done.returncode == 0 else None
