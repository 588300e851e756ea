"""The command line: parse, call, print. Each command stands in a file of its own and loads its code when it runs.

Exit status: 0 done or clean, 1 findings or differences, 2 could not run.
"""

import argparse
import os
import sys
from collections.abc import Sequence

from app import __version__
from app.cli import diff, export, function, lint, pull, releases, rule, serve, show, try_overlay
from app.errors import InputRefused, SigcatError

COMMANDS = (lint, diff, try_overlay, show, export, function, rule, pull, releases, serve)


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status. Nothing that a user does ends in a traceback."""
    try:
        arguments = _parser().parse_args(argv)
        status: int = arguments.run(arguments)
        sys.stdout.flush()
    except InputRefused as error:
        for finding in error.findings:
            print(finding.line_of_text, file=sys.stderr)
        return _failed(str(error), 1)
    except SigcatError as error:
        return _failed(str(error), 2)
    except OSError as error:
        return _output_closed() if isinstance(error, BrokenPipeError) else _failed(_reason(error), 2)
    except KeyboardInterrupt:
        return 130
    except Exception as error:
        if os.environ.get("SIGCAT_DEBUG"):
            raise
        return _failed(f"internal error: {type(error).__name__}: {error} (SIGCAT_DEBUG=1 shows where)", 2)
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="sigcat",
        description="A signal catalogue: browse, lint and export VSS trees with their interfaces, build functions.",
        epilog="Exit status: 0 done or clean, 1 findings or differences, 2 could not run.",
    )
    parser.add_argument("--version", action="version", version=f"sigcat {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for command in COMMANDS:
        command.add_parser(commands)
    return parser


def _failed(message: str, status: int) -> int:
    print(f"sigcat: {message}", file=sys.stderr)
    return status


def _reason(error: OSError) -> str:
    return f"{error.filename}: {error.strerror}" if error.filename else str(error)


def _output_closed() -> int:
    """The reader of our output has gone, as `head` does: stop quietly, and keep Python from complaining at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 0
