"""Write results: to standard output, or to a file that appears whole or not at all."""

import os
import sys
from contextlib import suppress
from pathlib import Path

from sigcat.errors import UsageError


def write_text(text: str, output: Path | None) -> None:
    """Write `text`, as UTF-8 with `\\n` at the ends of lines, to `output` or to standard output."""
    if output is None or str(output) == "-":
        encoding = sys.stdout.encoding or "utf-8"
        with suppress(AttributeError, OSError, ValueError):  # no file, or no such thing here
            os.set_blocking(sys.stdout.fileno(), True)  # a slow reader is waited for; some build servers ask not to
        sys.stdout.write(text.encode(encoding, "backslashreplace").decode(encoding))
    else:
        write_bytes(text.encode("utf-8", "backslashreplace"), output)


def discard_output() -> None:
    """Let the rest of the output go nowhere: its reader has gone, as `head` does, and Python would complain at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def write_bytes(data: bytes, output: Path | None) -> None:
    """Write `data` to `output`, or to standard output. A file that stood there stays until the new one is complete."""
    if output is None or str(output) == "-":
        sys.stdout.flush()
        sys.stdout.buffer.write(data)
        return
    if output.is_dir():
        raise UsageError(f"{output}: is a folder")
    if not output.parent.is_dir():
        raise UsageError(f"{output.parent}: there is no such folder")
    import tempfile

    handle, temporary = tempfile.mkstemp(dir=output.parent, prefix=f".{output.name}.")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        Path(temporary).chmod(output.stat().st_mode & 0o777 if output.exists() else 0o666 & ~_umask())
        Path(temporary).replace(output)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
