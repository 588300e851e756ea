"""Files that are published or checked: functions as one set, overlays, and the tree of a catalogue."""

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from sigcat.cli.project_options import project_of
from sigcat.cli.tree_options import read_tree, tree_options
from sigcat.errors import UsageError, existing_file
from sigcat.real_path import real_path

if TYPE_CHECKING:
    from sigcat.catalogue.hosting.source import Source
    from sigcat.catalogue.model.catalogue import Catalogue


class PublishedFiles(NamedTuple):
    """Files by their kind."""

    functions: tuple[Path, ...]
    overlays: tuple[Path, ...]
    trees: tuple[Path, ...]


def published_files(files: Sequence[Path]) -> PublishedFiles:
    """Return the files by their kind. Raises UsageError for others."""
    from sigcat.file_kind import file_kind, root_branch

    sorted_by: dict[str, list[Path]] = {"function": [], "overlay": [], "tree": []}
    for file in map(existing_file, dict.fromkeys(files)):
        data = file.read_bytes()
        kind = file_kind(data, file.name)
        if kind in ("function", "function json"):
            sorted_by["function"].append(file)
        elif kind == "vspec":
            sorted_by["tree" if root_branch(data) else "overlay"].append(file)
        else:
            raise UsageError(f"{file} must be a function, an overlay or the root .vspec file of a tree")
    return PublishedFiles(*map(tuple, sorted_by.values()))


def with_overlays(arguments: argparse.Namespace, overlays: Sequence[Path]) -> argparse.Namespace:
    """The options with more overlays: a file of a command may need those before it."""
    return argparse.Namespace(**{**vars(arguments), "overlays": [*arguments.overlays, *overlays]})


def read_catalogue(arguments: argparse.Namespace, tree: Path) -> "tuple[Source, Catalogue]":
    """The catalogue of the project that has this tree, else the tree with the overlays of the options."""
    from sigcat.project.chosen_tree import chosen_tree

    project = project_of(arguments)
    of_project = (source.id for source in project.catalogues if real_path(source.spec) == real_path(tree))
    chosen = argparse.Namespace(**{**vars(arguments), "vspec": Path(next(of_project, str(tree)))})
    return chosen_tree(project, tree_options(chosen)), read_tree(chosen)
