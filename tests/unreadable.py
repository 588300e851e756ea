"""Folders that cannot be read, for root too."""

import errno
import os
from pathlib import Path

import pytest


def unreadable(folder: Path, patch: pytest.MonkeyPatch) -> None:
    """Let the operating system refuse to list a folder."""
    listed = os.scandir

    def refuse(path: str | Path = ".") -> object:
        if Path(path) == folder:
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))
        return listed(path)

    patch.setattr(os, "scandir", refuse)
