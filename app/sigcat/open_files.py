"""Texts that are open in an editor: they are read in place of their files. A command has none.

Parsed files are kept from one lint of an editor to the next, and are used again until the file changes.
"""

import os
from collections.abc import Callable, Hashable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

Made = TypeVar("Made")


class OpenFiles(NamedTuple):
    """The texts of an editor by absolute path, and what was made of files."""

    texts: Mapping[str, bytes]
    made: dict[Hashable, tuple[object, Any]]
    """The stamp and the value of each slot: one value for each file, whatever changes in it."""


_CURRENT: ContextVar[OpenFiles | None] = ContextVar("open files", default=None)


@contextmanager
def open_files(texts: Mapping[str, bytes], made: dict[Hashable, tuple[object, Any]]) -> Iterator[None]:
    """Read these texts in place of their files, and keep in `made` what is made of files."""
    token = _CURRENT.set(OpenFiles(texts, made))
    try:
        yield
    finally:
        _CURRENT.reset(token)


def open_text(path: Path) -> bytes | None:
    """Return the text that is open for a file; None if there is none."""
    current = _CURRENT.get()
    return current.texts.get(os.path.abspath(path)) if current is not None else None  # noqa: PTH100 — links stay


def read_bytes(path: Path) -> bytes:
    """Return the open text of a file, else its bytes. Raises OSError."""
    text = open_text(path)
    return path.read_bytes() if text is None else text


def size_of(path: Path) -> int:
    """Return the number of bytes that `read_bytes` returns. Raises OSError."""
    text = open_text(path)
    return path.stat().st_size if text is None else len(text)


def is_file(path: Path) -> bool:
    """Whether there is a file, or an open text that was not saved yet."""
    return open_text(path) is not None or path.is_file()


def made_once(slot: Hashable, stamp: object, make: Callable[[], Made]) -> Made:
    """Return what `make` returns; in an editor, what it returned for the same stamp before."""
    current = _CURRENT.get()
    if current is None:
        return make()
    known = current.made.get(slot)
    if known is None or known[0] != stamp:
        known = current.made[slot] = stamp, make()
    value: Made = known[1]
    return value
