"""The command line: parse, call, print. Each command stands in a file of its own and loads its code when it runs.

Exit status: 0 done or clean, 1 findings or differences, 2 could not run.
"""

import argparse
import gc
import os
import re
import sys
from collections.abc import Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any, NoReturn

from sigcat import __version__
from sigcat.errors import InputRefused, SigcatError

COMMANDS = (
    "lint",
    "diff",
    "try",
    "show",
    "search",
    "export",
    "function",
    "integrate",
    "generate",
    "schema",
    "rule",
    "pull",
    "releases",
    "config",
    "serve",
)
"""Names of the commands; each stands in the module of its name."""
_MODULES = {"try": "try_overlay"}
"""Modules of commands whose names are words of Python."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status. Nothing that a user does ends in a traceback."""
    gc.set_threshold(50_000, 20)  # most of what a command makes stays to its end: looked through less often
    if sys.stdout is None:  # closed by the caller, as `>&-` does
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123, SIM115 — stands until the end
    try:
        given = sys.argv[1:] if argv is None else argv
        arguments = _parser(given[0] if given else "").parse_args(given)
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


vars(argparse)["_"] = str
"""Messages of argparse stay English, as all others are: `_Parser` reads them, and to look for translations takes 2 ms."""


class _Parser(argparse.ArgumentParser):
    """A parser that asks for the width of the terminal itself: argparse loads all of shutil for it."""

    def __init__(self, *arguments: Any, **named: Any) -> None:
        named.setdefault("formatter_class", partial(argparse.HelpFormatter, width=_columns() - 2))
        super().__init__(*arguments, **named)

    def error(self, message: str) -> NoReturn:
        """End with the name that was probably meant, where an option or a choice does not exist.

        Where only the command lacks, the commands are told.
        """
        if "arguments are required" in message and any(isinstance(action.choices, dict) for action in self._actions):
            self.print_help(sys.stderr)
            self.exit(2)
        wrong = re.search(r"unrecognized arguments: (-\S+)|invalid choice: '([^']*)'", message)
        if wrong:
            from sigcat.names import did_you_mean

            known = re.findall(r"'([^']+)'", message)[1:] if wrong[2] else list(self._options())
            message = f"{message}. {did_you_mean((wrong[1] or wrong[2]).partition('=')[0], known)}".rstrip(". ")
        super().error(message)

    def _options(self) -> Iterator[str]:
        """Names of the options of this parser and of its commands."""
        for action in self._actions:
            yield from action.option_strings
            commands = action.choices if isinstance(action.choices, dict) else {}
            for command in commands.values():
                yield from command._options()  # noqa: SLF001 — parsers of this class


def _parser(wanted: str) -> argparse.ArgumentParser:
    """The parser of the command `wanted`; of all commands where it is none of them, such as `--help`."""
    parser = _Parser(
        prog="sigcat",
        description="A signal catalogue: browse, lint and export VSS trees with their interfaces, build functions.",
        epilog="Exit status: 0 done or clean, 1 findings or differences, 2 could not run.",
    )
    parser.add_argument("--version", action="version", version=f"sigcat {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True, prog="sigcat")
    for name in (wanted,) if wanted in COMMANDS else COMMANDS:
        import_module(f"sigcat.cli.{_MODULES.get(name, name)}").add_parser(commands)
    return parser


def _columns() -> int:
    try:
        return int(os.environ.get("COLUMNS", "")) or 80
    except ValueError:
        pass
    try:
        return os.get_terminal_size().columns or 80
    except OSError:
        return 80


def _failed(message: str, status: int) -> int:
    print(f"sigcat: {message}", file=sys.stderr)
    return status


def _reason(error: OSError) -> str:
    if isinstance(error, IsADirectoryError):
        return f"{error.filename} is a folder; a file belongs here"
    return f"{error.filename}: {error.strerror}" if error.filename else str(error.strerror or error)


def _output_closed() -> int:
    from sigcat.cli.output import discard_output

    discard_output()
    return 0
