"""Marks of files when they were read: a changed mark means a changed file."""

from collections.abc import Iterable
from pathlib import Path

Marks = frozenset[tuple[str, int, int, int]]
"""Files and folders with time of change, size and inode: different as soon as one of them changes."""


def marks_of(paths: Iterable[Path]) -> Marks:
    """Marks of files and folders; a folder changes when a file that was missing appears in it."""
    return frozenset(_mark(path) for path in paths)


def _mark(path: Path) -> tuple[str, int, int, int]:
    try:
        status = path.stat()
    except OSError:
        return (str(path), 0, 0, 0)
    return (str(path), status.st_mtime_ns, status.st_size, status.st_ino)
