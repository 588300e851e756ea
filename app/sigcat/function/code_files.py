"""Files of the code that a declaration names and that are not there."""

from collections.abc import Callable, Iterable, Iterator
from pathlib import Path, PurePosixPath

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import CodeInterface, is_inside
from sigcat.function.function_json.resolved_function import ResolvedFunction

CodeCheck = Callable[[ResolvedFunction], Iterable[Finding]]
"""Finds what is wrong with the files of the code beside a declaration."""
IsThere = Callable[[str, str], bool]
"""Whether there is a file or folder, by the name of the declaration and the path that stands in it."""


def is_on_disk(declaration: str, path: str) -> bool:
    """Whether there is one beside a declaration that was read from a disk."""
    try:
        return (Path(declaration).parent / path).exists()
    except OSError:  # no file can have such a name
        return False


def missing_files(function: ResolvedFunction, is_there: IsThere) -> Iterator[Finding]:
    """A finding for each source, header or folder that is not there. Of Function JSON it is not known where they are."""
    code = function.function.code
    if code is None or function.origin is None:
        return
    for pointer, what, path, places in _named(code):
        if is_inside(path) and not any(is_there(function.document.name, place) for place in places):
            message = f"There is no {what} {path!r}."
            fix = "Correct the path, or add the file." if what != "folder" else "Correct the path, or add the folder."
            yield function.finding(codes.CODE_FILE_MISSING, pointer, message, fix)


def _named(code: CodeInterface) -> Iterator[tuple[Pointer, str, str, tuple[str, ...]]]:
    """What the code names: where, what it is, its path, and where it may be."""
    for index, path in enumerate(code.sources or ()):
        yield ("Code", "Sources", index), "file", path, (path,)
    folders = code.include_folders or ()
    for index, path in enumerate(code.headers or ()):
        places = (path, *(str(PurePosixPath(folder) / path) for folder in folders))
        yield ("Code", "Headers", index), "header", path, places
    for index, path in enumerate(folders):
        yield ("Code", "IncludeFolders", index), "folder", path, (path,)
