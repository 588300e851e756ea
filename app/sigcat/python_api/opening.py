"""Sources of catalogues: the project of a folder, or a tree with its additions."""

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from sigcat.catalogue.hosting.source import Source
    from sigcat.project.project import Project

PathLike = str | Path
Value = TypeVar("Value")


def read_project_of(folder: Path) -> "Project":
    """Return the project of the nearest sigcat.toml in `folder` or above it; without one, what sigcat ships.

    Raises InputRefused with everything that is wrong with the file.
    """
    from sigcat.project.find_project import find_project
    from sigcat.project.project import Project
    from sigcat.project.read_project import read_project

    file = find_project(folder)
    return Project() if file is None else read_project(file)


def sources_of(project: "Project") -> "tuple[Source, ...]":
    """Return the catalogues of a project, the default one first; without any, the one that commands use."""
    from sigcat.project.chosen_tree import TreeOptions, chosen_tree

    return project.catalogues or (chosen_tree(project, TreeOptions()),)


def absolute(value: Value) -> Value:
    """Return a value with absolute paths: a notebook may change the current folder."""
    if isinstance(value, Path):
        return value.absolute()
    if isinstance(value, tuple):
        items = map(absolute, value)
        return type(value)(*items) if hasattr(value, "_fields") else type(value)(items)
    return value


def tree_source(
    tree: PathLike,
    overlays: Iterable[PathLike],
    units: Iterable[PathLike],
    quantities: Iterable[PathLike],
    types: Iterable[PathLike],
    include_dirs: Iterable[PathLike],
) -> "Source":
    """Return a tree with what is added to it. Raises UsageError, or NotFound with near names."""
    from sigcat.project.chosen_tree import TreeOptions, chosen_tree
    from sigcat.project.project import Project

    folders = tuple(map(Path, include_dirs))
    added = TreeOptions(str(tree), _files(overlays), folders, _files(units), _files(quantities), _files(types))
    return chosen_tree(Project(), added)


def _files(paths: Iterable[PathLike]) -> tuple[Path, ...]:
    from sigcat.errors import existing_file

    return tuple(map(existing_file, paths))
