"""`sigcat lsp`."""

import argparse
import logging
import os
from collections.abc import Callable
from pathlib import Path

from sigcat.cli.project_options import add_project_options
from sigcat.errors import UsageError, existing_file


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "lsp",
        help="start the language server for editors",
        description="Start the language server (Language Server Protocol) on standard input and output. An editor starts it.",
    )
    parser.add_argument(
        "--stdio", action="store_true", help="use standard input and output, as always; editors pass it"
    )
    add_project_options(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Serve until the editor ends. Raises UsageError without the package that it needs."""
    try:
        from sigcat.lsp.server import make_server
    except ModuleNotFoundError as error:
        if error.name is None or error.name.partition(".")[0] not in ("pygls", "lsprotocol"):
            raise
        raise UsageError("the language server needs the extra `lsp`: run `pip install 'sigcat[lsp]'`") from None
    logging.getLogger("pygls").setLevel(logging.ERROR)  # standard error is shown to users by editors
    with os.fdopen(os.dup(0), "rb") as requests, os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # printed text is not a message of the protocol
        make_server(_finder(arguments)).start_io(requests, answers)
    return 0


def _finder(arguments: argparse.Namespace) -> "Callable[[Path], Path | None]":
    """Return the function that finds the project file of a folder."""
    from sigcat.project.find_project import find_project

    if arguments.isolated:
        return lambda _: None
    if arguments.config is None:
        return find_project
    named = existing_file(arguments.config).absolute()  # the editor says later which folder it is in
    return lambda _: named
