"""`sigcat mcp [FOLDER]`."""

import argparse
import os
from pathlib import Path

from sigcat.cli.project_options import add_project_options, project_of
from sigcat.errors import UsageError, existing_folder


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "mcp",
        help="serve look-ups to coding assistants (Model Context Protocol)",
        description="Serve a project to coding assistants over the Model Context Protocol, on standard input and output: "
        "search, show, lint, try, diff and who uses a signal. It reads files of the project and writes nothing.",
    )
    parser.add_argument(
        "folder",
        type=Path,
        nargs="?",
        default=Path(),
        metavar="FOLDER",
        help="folder of the project (default: this one)",
    )
    add_project_options(parser)
    parser.set_defaults(run=mcp)


def mcp(arguments: argparse.Namespace) -> int:
    """Serve until standard input is closed. Raises UsageError without the package mcp."""
    try:
        from sigcat.assistants.server import serve
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] not in ("mcp", "mcp_types"):
            raise
        raise UsageError("the server for assistants needs the extra `mcp`: run `pip install 'sigcat[mcp]'`") from None
    from sigcat.python_api.project import Project

    folder = existing_folder(arguments.folder)
    project = Project(project_of(arguments, folder), folder)
    os.chdir(folder)  # names of files in questions are relative to it
    serve(project, project.root)
    return 0
