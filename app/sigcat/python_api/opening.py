"""Where catalogues come from: the project of a folder, or a tree with what is added to it."""

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from sigcat.catalogue.hosting.source import Source
    from sigcat.rules.linting.options import LintOptions

PathLike = str | Path


class Opened(NamedTuple):
    """What a project says."""

    sources: "tuple[Source, ...]"
    """Its catalogues, the default one first."""
    functions: tuple[Path, ...]
    """Folders of functions."""
    has_shipped_functions: bool
    lint: "LintOptions"
    root: Path
    """The folder of the project."""


def project_of(folder: Path) -> Opened:
    """Return the project of the nearest sigcat.toml in `folder` or above it; without one, what sigcat ships.

    Raises InputRefused with everything that is wrong with the file.
    """
    from sigcat.catalogue.hosting.configuration import FILE_NAME, read_configuration
    from sigcat.catalogue.hosting.sources import shipped_sources
    from sigcat.rules.linting.configuration import find_configuration, options_of
    from sigcat.rules.linting.options import LintOptions

    file = find_configuration(folder)
    if file is None or file.name != FILE_NAME:
        return Opened(shipped_sources()[:1], (), True, LintOptions(), folder)
    read = read_configuration(file, {"lint": options_of, "service": lambda *_: None})
    return Opened(
        read.sources or shipped_sources()[:1], read.functions, read.has_shipped, read.tables["lint"], file.parent
    )


def tree_source(
    tree: PathLike,
    overlays: Iterable[PathLike],
    units: Iterable[PathLike],
    quantities: Iterable[PathLike],
    types: Iterable[PathLike],
    include_dirs: Iterable[PathLike],
) -> "Source":
    """Return a tree with what is added to it. Raises UsageError, or NotFound with near names."""
    from sigcat.catalogue.hosting.sources import source_of_tree

    source = source_of_tree(str(tree))
    return source._replace(
        overlays=(*source.overlays, *_files(overlays)),
        units=(*source.units, *_files(units)),
        quantities=(*source.quantities, *_files(quantities)),
        types=_files(types) or source.types,
        include_dirs=(*source.include_dirs, *map(Path, include_dirs)),
    )


def _files(paths: Iterable[PathLike]) -> tuple[Path, ...]:
    from sigcat.errors import existing_file

    return tuple(map(existing_file, paths))
