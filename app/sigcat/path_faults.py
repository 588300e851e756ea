"""Faults of paths that a user names."""

import os
import stat
from contextlib import suppress
from pathlib import Path

from sigcat.file_kind import C_HEADERS, C_SOURCES, TREE_ENDINGS


def path_fault(path: Path, kind: str = "file") -> str:
    """A sentence about a file or folder (`kind`) that is missing or cannot be read; empty for one that can be used."""
    shown = repr(str(path))
    try:
        mode = path.stat().st_mode
        if stat.S_ISDIR(mode) != (kind == "folder"):
            return f"{shown} must be {'a folder, not a file' if kind == 'folder' else 'a file, not a folder'}."
        if kind == "folder":
            os.scandir(path).close()
        elif not stat.S_ISREG(mode):
            return f"{shown} must be a regular file."  # reading a pipe would wait
    except (FileNotFoundError, NotADirectoryError, ValueError):
        return (
            f"{shown} is a link to nothing." if path.is_symlink() else f"There is no {kind} {shown}.{near_name(path)}"
        )
    except OSError as error:
        return f"{shown} cannot be read: {error.strerror}."
    return ""


_ALIKE = (TREE_ENDINGS[1:], C_HEADERS, C_SOURCES)
"""Suffixes of files of one kind."""


def _is_alike(one: Path, other: Path) -> bool:
    """Whether two files are of one kind by their suffixes."""
    return one.suffix == other.suffix or any({one.suffix, other.suffix} <= {*suffixes} for suffixes in _ALIKE)


def near_name(path: Path, start: Path | None = None) -> str:
    """A proposal of a path beside one that is missing, after a space; empty if nothing beside it has a near name.

    The proposal is relative to `start`, if that is given.
    """
    from sigcat.names import nearest, question  # loaded only when something is wrong

    with suppress(OSError, ValueError):
        alike = sorted(each.name for each in os.scandir(path.parent) if _is_alike(path, Path(each.name)))
        near = [name for name in alike if Path(name).stem == path.stem] or nearest(path.name, alike, 1)
        found = [path.with_name(name) for name in near[:1]]
        return "".join(f" {question([str(each.relative_to(start) if start else each)])}" for each in found)
    return ""
