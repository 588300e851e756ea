"""The options that say which project a command is in, and its project."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output import could_not_run
from sigcat.errors import InputRefused

if TYPE_CHECKING:
    from collections.abc import Mapping

    from sigcat.project.project import Project
    from sigcat.project.project_file import TableReader


def add_project_options(parser: argparse._ActionsContainer) -> None:
    """Add --config and --isolated."""
    group = parser.add_mutually_exclusive_group()
    group.add_argument(
        "--config", type=Path, metavar="FILE",
        help="project file (default: SIGCAT_CONFIG, or the nearest sigcat.toml upwards)",
    )  # fmt: skip
    group.add_argument("--isolated", action="store_true", help="ignore the project file")


def project_of(
    arguments: argparse.Namespace, start: Path = Path(), readers: "Mapping[str, TableReader] | None" = None
) -> "Project":
    """Return the project that the options name, else that of the folder `start`; it is read once.

    Raises UsageError; findings are printed.
    """
    if not hasattr(arguments, "project"):
        arguments.project = _read(arguments, start, readers)
    project: Project = arguments.project
    return project


def _read(arguments: argparse.Namespace, start: Path, readers: "Mapping[str, TableReader] | None") -> "Project":
    from sigcat.project.find_project import find_project
    from sigcat.project.project import Project

    file = None if arguments.isolated else arguments.config or find_project(start)
    if file is None:
        return Project()
    from sigcat.project.read_project import read_project

    try:
        return read_project(file, readers)
    except InputRefused as error:
        raise could_not_run(error) from None
