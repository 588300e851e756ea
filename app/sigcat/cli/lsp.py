"""`sigcat lsp`."""

import argparse
import logging
import os

from sigcat.errors import UsageError


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
    parser.set_defaults(run=run)


def run(_: argparse.Namespace) -> int:
    """Serve until the editor ends. Raises UsageError without the package that it needs."""
    try:
        from sigcat.lsp.server import make_server
    except ModuleNotFoundError as error:
        if error.name is None or error.name.partition(".")[0] not in ("pygls", "lsprotocol"):
            raise
        raise UsageError("the language server needs the extra `lsp`: run `pip install 'sigcat[lsp]'`") from None
    logging.getLogger("pygls").setLevel(logging.ERROR)  # standard error is shown to users by editors
    with os.fdopen(os.dup(0), "rb") as requests, os.fdopen(os.dup(1), "wb") as answers:
        os.dup2(2, 1)  # what is printed is no message of the protocol
        make_server().start_io(requests, answers)
    return 0
