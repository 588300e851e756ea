"""`sigcat mcp [FOLDER]`."""

import argparse
import os
from pathlib import Path

from sigcat.errors import UsageError


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
    parser.set_defaults(run=mcp)


def mcp(arguments: argparse.Namespace) -> int:
    """Serve until standard input is closed. Raises UsageError without the package mcp."""
    try:
        from sigcat.assistants.server import serve
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] not in ("mcp", "mcp_types"):
            raise
        raise UsageError("this needs the package `mcp`: run `pip install mcp`") from None
    from sigcat.python_api.project import open_project

    project = open_project(arguments.folder)
    os.chdir(arguments.folder)  # names of files in questions are relative to it
    serve(project, project.root)
    return 0
