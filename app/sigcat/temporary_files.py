"""Folders for temporary files: in the place that the environment names, and no other.

A process that is killed cannot remove its folders and hidden files. The next one that makes some for the same purpose does:
each is locked by its process, and the system unlocks it when that ends.
"""

import os
import re
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from weakref import finalize

from sigcat.errors import NoRoom

_VARIABLES = ("TMPDIR", "TEMP", "TMP")
_LOCK = ".sigcat-lock"
_FRAGMENT = r"\.{}\.[0-9a-f]{{12}}"
_RECENT = 60.0
"""Seconds after which a hidden file that nothing has locked is left behind: it is locked right after it is made."""


class _TemporaryFolder(tempfile.TemporaryDirectory[str]):
    """A temporary folder that is locked as long as it is used."""

    def __init__(self, prefix: str, place: str | None) -> None:
        super().__init__(prefix=prefix, dir=place, ignore_cleanup_errors=True)
        unnamed = Path(self.name) / f"{_LOCK}-new"
        number = os.open(unnamed, os.O_CREAT | os.O_RDWR, 0o600)
        finalize(self, _close, number)
        if is_locked_here(number):
            unnamed.rename(unnamed.with_name(_LOCK))  # with its name it is locked: other processes look for that


def temporary_folder(prefix: str) -> "tempfile.TemporaryDirectory[str]":
    """A new folder, which is removed when it is left. Raises NoRoom where none can be made.

    Folders that killed processes left there with the same prefix are removed. Python takes another place in silence where
    the one that is named is full or not there.
    """
    place = next(filter(None, map(os.environ.get, _VARIABLES)), None)
    try:
        folder = _TemporaryFolder(prefix, place)
    except OSError as error:
        reason = error.strerror or error
        raise NoRoom(
            f"Temporary files cannot be written: {reason}. Free some space, or let TMPDIR name another folder."
        ) from None
    for left in _abandoned(Path(folder.name).parent, prefix):
        shutil.rmtree(left, ignore_errors=True)
    return folder


def _abandoned(place: Path, prefix: str) -> Iterator[Path]:
    for each in _entries(place):
        if each.name.startswith(prefix):
            with suppress(OSError):
                if each.stat(follow_symlinks=False).st_uid == os.getuid() and _is_unlocked(Path(each.path, _LOCK)):
                    yield Path(each.path)


def fragment_of(target: Path) -> Path:
    """The name of a new hidden file, which replaces `target` when it is complete."""
    return target.with_name(f".{target.name}.{os.urandom(6).hex()}")


def remove_fragments(target: Path) -> None:
    """Remove hidden files that killed processes left while they wrote `target`."""
    name = re.compile(_FRAGMENT.format(re.escape(target.name)))
    for each in _entries(target.parent):
        with suppress(OSError):
            if name.fullmatch(each.name) and each.is_file(follow_symlinks=False) and _is_left(each):
                os.unlink(each.path)  # noqa: PTH108 — no Path for each file of a folder


def _is_left(entry: "os.DirEntry[str]") -> bool:
    is_recent = time.time() - entry.stat(follow_symlinks=False).st_mtime < _RECENT
    return not is_recent and _is_unlocked(Path(entry.path))


def is_locked_here(number: int) -> bool:
    """Lock an open file until it is closed. False if another process has locked it, or the system has no locks."""
    try:
        import fcntl

        fcntl.flock(number, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (ImportError, OSError):
        return False
    return True


def _is_unlocked(file: Path) -> bool:
    """Whether there is a file that no process has locked."""
    number = os.open(file, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0))
    try:
        return is_locked_here(number)
    finally:
        os.close(number)


def _entries(folder: Path) -> "list[os.DirEntry[str]]":
    try:
        return list(os.scandir(folder))
    except OSError:
        return []


def _close(number: int) -> None:
    with suppress(OSError):
        os.close(number)
