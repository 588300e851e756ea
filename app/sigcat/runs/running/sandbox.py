"""A sandbox for the process of a run: bubblewrap, which shows it the system's libraries, and no network and no files."""

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from sigcat.errors import UsageError

_SYSTEM = ("/usr", "/lib", "/lib32", "/lib64", "/bin", "/sbin", "/etc/ld.so.cache", "/nix/store")
_TEMPORARY = "/tmp"  # noqa: S108 — that of the sandbox, which goes away with it
_MISSING = "--sandbox needs bubblewrap: install it (`apt install bubblewrap`), or run without --sandbox"


def sandbox(readable: Sequence[Path], writable: Sequence[Path]) -> tuple[str, ...]:
    """Words that start a command in a sandbox. Raises UsageError if bubblewrap is missing."""
    program = shutil.which("bwrap")
    if program is None:
        raise UsageError(_MISSING)
    shown = [word for path in _SYSTEM for word in ("--ro-bind-try", path, path)]
    shown += [word for path in readable for word in ("--ro-bind", str(path), str(path))]
    shown += [word for path in writable for word in ("--bind", str(path), str(path))]
    return (
        program, "--unshare-all", "--die-with-parent", "--new-session", "--cap-drop", "ALL", "--clearenv", "--proc", "/proc",
        "--dev", "/dev", "--tmpfs", _TEMPORARY, *shown, "--chdir", _TEMPORARY, "--",
    )  # fmt: skip


def check_sandbox() -> None:
    """Raise UsageError if bubblewrap cannot run a program here."""
    done = subprocess.run([*sandbox((), ()), "/bin/true"], capture_output=True, text=True, check=False)  # noqa: S603
    if done.returncode:
        raise UsageError(f"--sandbox: bubblewrap does not work here: {done.stderr.strip()}")
