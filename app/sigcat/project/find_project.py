"""Find the project file: in a folder or above it."""

import os
from pathlib import Path

from sigcat.project.project import FILE_NAME
from sigcat.real_path import near_path, real_path

FILES = (FILE_NAME, "pyproject.toml")
VARIABLE = "SIGCAT_CONFIG"
"""Names the file, where no option does."""


def find_project(start: Path) -> Path | None:
    """Return the file that SIGCAT_CONFIG names, or the nearest one in `start` or above it."""
    if named := os.environ.get(VARIABLE):
        return Path(named)
    return nearest_project(start)


def nearest_project(start: Path, top: Path | None = None) -> Path | None:
    """Return the nearest file in `start` or above it, up to `top`. A pyproject.toml counts only with a table for sigcat."""
    for folder in (real_path(start), *real_path(start).parents):
        for name in FILES:
            path = folder / name
            if path.exists() if name == FILE_NAME else path.is_file() and b"[tool.sigcat" in path.read_bytes():
                return near_path(path)
        if folder == top:
            break
    return None
