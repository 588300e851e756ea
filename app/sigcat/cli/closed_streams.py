"""Standard streams that the caller closed, as `>&-` and `<&-` do."""

import errno
import os
import sys

from sigcat.errors import UsageError


def reopen_closed_streams() -> None:
    """Open streams that were closed: files would get their numbers.

    Writing to standard output is an error, so that a result is not lost silently. Messages are lost.
    """
    if sys.stdout is None:
        os.dup2(os.open(os.devnull, os.O_RDONLY), 1)
        sys.stdout = open(1, "w", encoding="utf-8", closefd=False)  # noqa: SIM115 — stands until the end
    if sys.stderr is None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        sys.stderr = open(2, "w", encoding="utf-8", closefd=False)  # noqa: SIM115 — stands until the end


def is_closed_output(error: OSError) -> bool:
    """Whether an error is that of writing to a standard output that was closed."""
    return error.errno == errno.EBADF and error.filename is None


def input_bytes() -> bytes:
    """Return what standard input has. Raises UsageError if it is closed."""
    if sys.stdin is None:
        raise UsageError("standard input is closed: open it, or name a file")
    return sys.stdin.buffer.read()
