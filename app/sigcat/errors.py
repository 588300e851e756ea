"""The one exception tree.

SigcatError
├── InputRefused        an input cannot be used; carries the findings that say why
│   └── RegistryUnusable    the database of the registry is full, locked, gone, or of another program
├── NoRoom              no space left for temporary files
├── NotFound            a catalogue, node, rule or file that was named does not exist
├── ToolCrashed         a tool that sigcat runs ended before it was done
└── UsageError          a command or request asks for something that cannot be done
"""

import os
from pathlib import Path

from sigcat.findings import Finding


class SigcatError(Exception):
    """Base of every error that sigcat raises on purpose; its text is written for users."""


_SHOWN = 10
"""Findings that a traceback shows."""


class InputRefused(SigcatError):
    """An input cannot be used. `findings` has every reason, not the first one only; a traceback shows the first of them."""

    def __init__(self, message: str, findings: tuple[Finding, ...] = ()) -> None:
        super().__init__(message)
        self.findings: tuple[Finding, ...] = findings
        for finding in findings[:_SHOWN]:
            self.add_note(finding.line_of_text)


class RegistryUnusable(InputRefused):
    """The database of the registry cannot be used, which says nothing of the input."""

    def __init__(self, message: str, findings: tuple[Finding, ...] = (), *, is_full: bool = False) -> None:
        super().__init__(message, findings)
        self.is_full = is_full


class NoRoom(SigcatError):
    """No space left for temporary files."""


class NotFound(SigcatError):
    """A catalogue, node, rule or file that was named does not exist. `nearest` are names that do."""

    def __init__(self, message: str, nearest: tuple[str, ...] = ()) -> None:
        super().__init__(message)
        self.nearest: tuple[str, ...] = nearest


class ToolCrashed(SigcatError):
    """A tool that sigcat runs ended before it was done, which says nothing of the input."""


class UsageError(SigcatError):
    """A command or request asks for something that cannot be done."""


def existing_file(path: str | os.PathLike[str]) -> Path:
    """The path of a file that a user named. Raises UsageError."""
    file = Path(path)
    if file.is_dir():
        raise UsageError(must_be_a_file(path))
    if not file.is_file():
        raise UsageError(f"{path} must be a regular file" if file.exists() else f"{path}: there is no such file")
    return file


def existing_folder(path: str | os.PathLike[str]) -> Path:
    """The path of a folder that a user named. Raises UsageError."""
    folder = Path(path)
    if not folder.is_dir():
        raise UsageError(f"{path} must be a folder" if folder.exists() else f"{path}: there is no such folder")
    return folder


def without_signals(tree: str | os.PathLike[str]) -> str:
    """Return the message for a tree without signals."""
    return f"{tree}: the catalogue has no signals; name the root .vspec file of a tree"


def must_be_a_file(path: str | os.PathLike[str]) -> str:
    """Return the message for a folder in place of a file."""
    return f"{path} must be a file, not a folder"
