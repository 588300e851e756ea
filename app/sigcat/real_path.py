"""The target of a path."""

import os
from collections.abc import Iterable
from pathlib import Path


def real_path(path: Path) -> Path:
    """With every link followed. One that leads to itself stays as it is: before Python 3.13 `Path.resolve` has no OSError for it."""
    return Path(os.path.realpath(path))


def near_path(path: Path) -> Path:
    """The path as a user names it: relative to the current folder where it is below it."""
    try:
        return real_path(path).relative_to(Path.cwd())
    except ValueError:
        return path


def each_once(paths: Iterable[Path]) -> tuple[Path, ...]:
    """The paths in order, each file by the first of its names."""
    by_place: dict[Path, Path] = {}
    for path in paths:
        by_place.setdefault(real_path(path), path)
    return tuple(by_place.values())
