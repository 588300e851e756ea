"""Files of the code that a declaration names and that are missing or cannot be read."""

import errno
import stat
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path, PurePosixPath

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import CodeInterface, is_inside
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.path_faults import near_name

CodeCheck = Callable[[ResolvedFunction], Iterable[Finding]]
"""Finds faults of the files of the code next to a declaration."""
_START = 8_000
"""Bytes of a file that show whether it is a text."""


def missing_files(function: ResolvedFunction) -> Iterator[Finding]:
    """A finding for each source, header or folder that is missing or cannot be read.

    Of Function JSON it is not known where the files are.
    """
    code = function.function.code
    if code is None or function.origin is None:
        return
    folder = Path(function.document.name).parent
    for pointer, what, path, places in _files_named(code):
        faults = [_fault(folder / place, is_folder=what == "folder") for place in places] if is_inside(path) else [""]
        if all(faults):
            fault = next((each for each in faults if each != _MISSING), _MISSING)
            yield function.finding(codes.CODE_FILE_MISSING, pointer, *_about(what, path, fault, folder))


_MISSING = "missing"


def _about(what: str, path: str, fault: str, folder: Path) -> tuple[str, str]:
    """The message and the fix of a finding about a file of the code."""
    if fault == _MISSING:
        return (
            f"There is no {what} {path!r}.",
            f"{near_name(folder / path, folder)} Correct the path, or add the {'folder' if what == 'folder' else 'file'}.".lstrip(),
        )
    return f"{path!r} {fault}.", f"Name a {'folder' if what == 'folder' else 'C or C++ file that can be read'}."


def _fault(path: Path, *, is_folder: bool) -> str:
    """The end of a sentence about a file or folder that cannot be used; empty for one that can."""
    try:
        mode = path.stat().st_mode
        if is_folder:
            return "" if stat.S_ISDIR(mode) else "must be a folder, not a file"
        if stat.S_ISDIR(mode):
            return "must be a file, not a folder"
        if not stat.S_ISREG(mode):
            return "must be a regular file"  # a pipe would be waited for
        with path.open("rb") as file:
            return "is not a text in UTF-8 or a similar encoding" if b"\0" in file.read(_START) else ""
    except (FileNotFoundError, NotADirectoryError, ValueError):
        return _MISSING
    except OSError as error:
        return _MISSING if error.errno == errno.ENAMETOOLONG else f"cannot be read: {error.strerror}"


def _files_named(code: CodeInterface) -> Iterator[tuple[Pointer, str, str, tuple[str, ...]]]:
    """Files that the code names: pointer, kind, path, and possible places."""
    for index, path in enumerate(code.sources or ()):
        yield ("Code", "Sources", index), "file", path, (path,)
    folders = code.include_folders or ()
    for index, path in enumerate(code.headers or ()):
        places = (path, *(str(PurePosixPath(folder) / path) for folder in folders))
        yield ("Code", "Headers", index), "header", path, places
    for index, path in enumerate(folders):
        yield ("Code", "IncludeFolders", index), "folder", path, (path,)
