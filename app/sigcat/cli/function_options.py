"""The functions that a command works with: those that are named, else those of the project."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.project_options import project_of
from sigcat.cli.tree_options import read_tree
from sigcat.errors import UsageError, existing_file
from sigcat.file_kind import C_HEADERS, C_SOURCES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sigcat.catalogue.model.catalogue import Catalogue


def add_functions(parser: argparse.ArgumentParser) -> None:
    """Add the functions as arguments."""
    parser.add_argument(
        "functions", type=Path, nargs="*", metavar="FUNCTION",
        help="function.yaml or Function JSON (default: the functions of the project)",
    )  # fmt: skip


def add_function(parser: argparse.ArgumentParser) -> None:
    """Add one function as an argument."""
    text = "function.yaml (default: the only one of the project)"
    parser.add_argument("file", type=Path, nargs="?", metavar="FILE", help=text)


_TABLES = (".csv", ".mcap")
"""Endings of traces."""


def _refuse_other(path: Path, *, takes_trace: bool) -> None:
    """Raise UsageError for code and traces, which are often named in place of functions."""
    ending = path.suffix.lower()
    if ending in (*C_SOURCES, *C_HEADERS):
        raise UsageError(f"{path} is code: name the function file that lists it")
    if ending in _TABLES:
        advice = "name a trace with --trace" if takes_trace else "name a function file"
        raise UsageError(f"{path} is a table: {advice}")


def functions_of(arguments: argparse.Namespace) -> tuple[Path, ...]:
    """Return the files that are named, else those of the project, which no output may replace. Raises UsageError."""
    for path in arguments.functions:
        _refuse_other(path, takes_trace=hasattr(arguments, "trace"))
    arguments.functions = list(map(existing_file, arguments.functions)) or list(project_functions(arguments))
    return tuple(arguments.functions)


def project_functions(arguments: argparse.Namespace) -> tuple[Path, ...]:
    """Return the files of the project. Raises UsageError if there are none."""
    from sigcat.function.folder_functions import folder_functions

    folders = project_of(arguments).functions
    found = folder_functions(folders)
    if not found:
        where = f"no function in {', '.join(map(str, folders))}" if folders else "no `functions` in a project file"
        raise UsageError(f"name a function.yaml: there is {where}")
    return found


def one_function(arguments: argparse.Namespace) -> Path:
    """Return the file that is named, else the only one of the project. Raises UsageError."""
    found = (existing_file(arguments.file),) if arguments.file is not None else project_functions(arguments)
    if len(found) > 1:
        raise UsageError(f"name one of the functions of the project: {', '.join(map(str, found))}")
    arguments.file = found[0]
    return found[0]


def tree_for_functions(arguments: argparse.Namespace, files: "Sequence[tuple[bytes, str]]") -> "Catalogue":
    """Return the tree for some of the project's functions, with what its other functions define if they need that."""
    from sigcat.function.sets.others import with_others

    return with_others(files, read_tree(arguments), project_of(arguments).functions)


def deployment_of(arguments: argparse.Namespace, other: Path | None = None) -> Path | None:
    """Return the deployment file that is named, else `other`, else that of the project."""
    named = arguments.deployment or other or project_of(arguments).deployment
    return existing_file(named) if named is not None else None
