"""The machine that figures were measured on."""

import os
import platform
import subprocess
from collections.abc import Iterator
from pathlib import Path

from sigcat.adapter.toolchain import Toolchain

_CPU = Path("/proc/cpuinfo")


def machine(tools: Toolchain) -> tuple[tuple[str, str], ...]:
    """Return properties of the machine that figures depend on, as (name, value)."""
    return tuple(_facts(tools))


def _facts(tools: Toolchain) -> Iterator[tuple[str, str]]:
    yield "processor", _processor()
    yield "cores", str(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count())
    yield "system", f"{platform.system()} {platform.release()}"
    yield "compiler", _version(tools)
    yield "Python", platform.python_version()
    if hasattr(os, "getloadavg"):
        yield "processes that wanted to run, before it began", f"{os.getloadavg()[0]:.1f}"


def _processor() -> str:
    try:
        lines = _CPU.read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def _version(tools: Toolchain) -> str:
    done = subprocess.run([*tools.c, "--version"], check=False, capture_output=True, text=True)  # noqa: S603 - no shell
    return done.stdout.partition("\n")[0]
