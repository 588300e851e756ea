"""The function files of folders: declarations, and Function JSON of functions that none of them declares."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sigcat.function.declaration.declaration import Declared
from sigcat.function.function_file import FunctionFile, read_function_file
from sigcat.function.hosted_files import HostedFile, files_in


def folder_functions(folders: Iterable[Path]) -> tuple[Path, ...]:
    """Return the files in and below the folders, in order."""
    found = [file for folder in folders for file in files_in(folder) if not file.is_skipped]
    declared = {_name(file) for file in found if not file.is_json}
    return tuple(file.path for file in found if not (file.is_json and _name(file) in declared))


def _name(file: HostedFile) -> Any:
    return name_of(read_function_file(file.data, file.name))


def name_of(read: FunctionFile) -> Any:
    """Return the name of the function; None if the file has none."""
    document = (read.document if isinstance(read, Declared) else read).value
    if not isinstance(document, dict):
        return None
    info = document.get("FunctionInfo")
    return info.get("FunctionName") if isinstance(info, dict) else document.get("function")
