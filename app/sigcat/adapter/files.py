"""Generated files of an adapter, by name and content. The caller writes them."""

from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple


class GeneratedFile(NamedTuple):
    """One file; the name has forward slashes and no folder above it."""

    name: str
    data: bytes


def shipped(folder: Path) -> tuple[GeneratedFile, ...]:
    """The files of a folder of this package as they are, by their paths below it."""
    found = sorted(path for path in folder.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
    return tuple(GeneratedFile(path.relative_to(folder).as_posix(), path.read_bytes()) for path in found)


def within(folder: str, files: Iterable[GeneratedFile]) -> tuple[GeneratedFile, ...]:
    """The files in a folder."""
    return tuple(file._replace(name=f"{folder}/{file.name}") for file in files)
