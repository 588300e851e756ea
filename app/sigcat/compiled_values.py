"""Values made of files that sigcat ships, kept the way Python keeps compiled modules: in a `__pycache__`.

That folder is writable only for users who may change the files. What is kept counts only with the stamp that it was
written with.
"""

import marshal
import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from typing import Any

from sigcat import __version__

Stamp = tuple[tuple[str, int, int], ...]


def stamp_of(files: Iterable[Path]) -> Stamp:
    """Name, size and time of each file; nothing if one cannot be found, as in a zipped package."""
    try:
        stats = [(str(file), file.stat()) for file in files]
    except OSError:
        return ()
    return tuple((name, stat.st_size, stat.st_mtime_ns) for name, stat in stats)


def stamp_of_values(folder: Path, name: str) -> Stamp:
    """Stamp of the file that has the values which are stored under a name; nothing without one."""
    return stamp_of((_file(folder, name),))


def read_values(folder: Path, name: str, stamp: Stamp) -> Any:
    """Return the value that was stored in a folder under a name, with this stamp; None without one."""
    try:
        written, values = marshal.loads(_file(folder, name).read_bytes())  # noqa: S302 — trusted as compiled Python is
    except (OSError, ValueError, TypeError, EOFError):
        return None
    return values if stamp and written == stamp else None


def write_values(folder: Path, name: str, stamp: Stamp, values: Any) -> None:
    """Keep values of types that marshal knows, if the folder can be written: whole or not at all, as several may do it at once."""
    if not stamp or sys.dont_write_bytecode or sys.pycache_prefix:
        return
    file = _file(folder, name)
    temporary = file.with_name(f"{file.name}.{os.getpid()}")
    with suppress(OSError, ValueError):
        file.parent.mkdir(exist_ok=True)
        temporary.write_bytes(marshal.dumps((stamp, values)))
        temporary.replace(file)


def _file(folder: Path, name: str) -> Path:
    return folder / "__pycache__" / f"{name}-{__version__}.{sys.implementation.cache_tag}.marshal"
