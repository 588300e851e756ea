"""The function files of folders: declarations, and Function JSON of functions that none of them declares."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from sigcat.function.declaration.declaration import Declared
from sigcat.function.function_file import read_function_file
from sigcat.function.hosted_files import HostedFile, files_in


def folder_functions(folders: Iterable[Path]) -> tuple[Path, ...]:
    """Return the files in and below the folders, in order."""
    found = [file for folder in folders for file in files_in(folder) if not file.is_skipped]
    declared = {_name_of(file) for file in found if not file.is_json}
    return tuple(file.path for file in found if not (file.is_json and _name_of(file) in declared))


def _name_of(file: HostedFile) -> Any:
    """Return the name of the function; None if the file has none."""
    read = read_function_file(file.data, file.name)
    document = (read.document if isinstance(read, Declared) else read).value
    if not isinstance(document, dict):
        return None
    info = document.get("FunctionInfo")
    return info.get("FunctionName") if isinstance(info, dict) else document.get("function")
