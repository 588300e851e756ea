"""The files of a folder that are read: C and C++, within limits; nothing outside of the folder."""

import os
import posixpath
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.file_kind import C_HEADERS, C_SOURCES
from sigcat.findings import Finding
from sigcat.limits import CODE_BYTES, CODE_FILE_BYTES, CODE_FILES
from sigcat.line_numbers import numbered
from sigcat.real_path import real_path

HEADERS, SOURCES = frozenset(C_HEADERS), frozenset(C_SOURCES)
_OUTSIDE = re.compile(
    r"^(?P<before>[ \t]*(?:#|%:|\?\?=)[ \t]*(?:include|include_next|import|embed)\b[ \t]*[\"<][ \t]*)"
    r"(?P<path>[/\\][^\"<>\n]*|[A-Za-z]:[^\"<>\n]*)",
    re.MULTILINE,
)


def is_header(path: str) -> bool:
    """Whether a file is a header, by its name."""
    return Path(path).suffix.lower() in HEADERS


class CodeFiles(NamedTuple):
    """Texts by path within the folder, and what was found wrong with files."""

    texts: Mapping[str, str]
    findings: tuple[Finding, ...] = ()
    definitions: tuple[str, ...] = ()
    """For the preprocessor: `NAME` or `NAME=VALUE`."""

    @property
    def sources(self) -> tuple[str, ...]:
        """The files that are compiled."""
        return tuple(path for path in self.texts if Path(path).suffix.lower() in SOURCES)

    @property
    def folders(self) -> tuple[str, ...]:
        """The folders in which headers are."""
        return tuple(dict.fromkeys(Path(path).parent.as_posix() for path in self.texts if is_header(path)))


def read_folder(folder: Path) -> CodeFiles:
    """Read the code below a folder. Links that lead out of it are not followed."""
    findings: list[Finding] = []
    texts: dict[str, str] = {}
    left = CODE_BYTES
    for path in _code_below(folder, findings):
        text = _text(folder, path, left, findings)
        if text is not None:
            left -= len(text)
            texts[path] = _without_outside(text, path, findings)
    return CodeFiles(texts, tuple(findings))


_INCLUDE = re.compile(r"^[ \t]*#[ \t]*include[ \t]*[<\"](?P<path>[^<>\"\n]+)[>\"]", re.MULTILINE)


def headers_of(folder: Path, headers: Sequence[str], folders: Sequence[str]) -> Mapping[str, str] | None:
    """Texts of headers and of the headers that they include, by path below a folder; None if a header is missing.

    What they include and the folder does not have is left out: it is the system's, or missing.
    """
    texts: dict[str, str] = {}
    findings: list[Finding] = []
    left = [(path, "") for path in headers]
    while left and len(texts) < CODE_FILES:
        name, beside = left.pop()
        places = (posixpath.normpath(f"{place}/{name}") for place in dict.fromkeys((beside or ".", ".", *folders)))
        path = next((each for each in places if not each.startswith(("..", "/")) and (folder / each).is_file()), None)
        if path is None and not beside:
            return None
        if path is None or path in texts:
            continue
        text = _text(folder, path, CODE_BYTES, findings)
        if text is not None:
            texts[path] = _without_outside(text, path, findings)
            left += [(match["path"], posixpath.dirname(path) or ".") for match in _INCLUDE.finditer(texts[path])]
    return texts


def _code_below(folder: Path, findings: list[Finding]) -> list[str]:
    """Paths of the files, in the order of the alphabet; of too many, the first ones."""
    found: list[str] = []
    for path in _walk(folder):
        if path.suffix.lower() not in HEADERS | SOURCES:
            continue
        if len(found) == CODE_FILES:
            message = f"The folder must have at most {CODE_FILES:,} files of C; those after {found[-1]} are not read."
            findings.append(codes.CODE_UNREADABLE.finding(message, str(folder), fix="Name the folder of one model."))
            break
        found.append(path.relative_to(folder).as_posix())
    return found


def _walk(folder: Path) -> Iterator[Path]:
    """Files in the order of their names, with those of a folder before those of the folders in it."""
    for parent, folders, files in os.walk(folder):
        folders.sort()
        yield from (Path(parent) / name for name in sorted(files))


def _text(folder: Path, path: str, left: int, findings: list[Finding]) -> str | None:
    """The text of a file; None, with a finding, if it cannot be read."""
    data, reason = _bytes(folder / path, folder, left)
    if data is None or b"\0" in data:
        message = f"The file cannot be read: it {reason or 'has null bytes, so that it is not C'}."
        findings.append(codes.CODE_UNREADABLE.finding(message, path))
        return None
    return data.decode("utf-8-sig", "replace")


def _bytes(file: Path, folder: Path, left: int) -> tuple[bytes | None, str]:
    """Content of a file, or why it is not read."""
    try:
        if not real_path(file).is_relative_to(real_path(folder)):
            return None, "is a link that leads out of the folder"
        if not file.is_file():
            return None, "is not a regular file"
        size = file.stat().st_size
        if size > CODE_FILE_BYTES:
            return None, f"has more than {CODE_FILE_BYTES:,} bytes"
        if size > left:
            return None, f"is beyond the {CODE_BYTES:,} bytes that are read of a folder"
        return file.read_bytes(), ""
    except OSError as error:
        return None, f"gives an error: {error.strerror}"


def _without_outside(text: str, path: str, findings: list[Finding]) -> str:
    """The text with includes of files elsewhere on the machine left empty; lines stay where they are."""
    for line, match in numbered(text, _OUTSIDE.finditer(text)):
        message = f"The include must be within the folder, not {match['path']!r}; it is left out."
        findings.append(codes.INCLUDE_NOT_FOUND.finding(message, path, line))
    return _OUTSIDE.sub(lambda match: f"{match['before']}left-out", text)
