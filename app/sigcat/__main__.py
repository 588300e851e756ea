"""The command `sigcat`, and `python -m sigcat`."""

import os
import sys
from contextlib import suppress
from typing import NoReturn


def main() -> int:
    """Run one command and return its exit status: 130 also for an interrupt while its modules are imported."""
    try:
        from sigcat.cli import main as run

        status = run()
    except KeyboardInterrupt:
        return 130
    if sys.argv[1:2] == ["lint"]:
        _end_at_once(status)
    return status


def _end_at_once(status: int) -> NoReturn:
    """End a process that has nothing to close, without freeing its objects: that is 6 % of a lint of one file."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError):
            stream.flush()
    os._exit(status)


if __name__ == "__main__":
    sys.exit(main())
