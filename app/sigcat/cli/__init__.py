"""The command line: parse, call, print. Each command has its own file and loads its code when it runs.

Exit status: 0 done, or nothing worse than a note; 1 findings, or changes that --fail-on names; 2 could not run.
"""

import atexit
import gc
import os
import sys
from collections.abc import Sequence
from importlib import import_module
from io import TextIOWrapper

from sigcat import __version__
from sigcat.cli.closed_streams import is_closed_output, reopen_closed_streams
from sigcat.cli.command_parser import CommandParser
from sigcat.cli.ended_by_signals import remembering_interrupts, was_interrupted
from sigcat.cli.output_options import refuse_overwriting
from sigcat.errors import InputRefused, RegistryUnusable, SigcatError, must_be_a_file
from sigcat.terminal_text import printable_lines

COMMANDS = (
    "init",
    "lint",
    "diff",
    "migrate",
    "version-bump",
    "try",
    "show",
    "search",
    "units",
    "vehicles",
    "export",
    "function",
    "integrate",
    "generate",
    "simulate",
    "normalize",
    "compare",
    "gateway",
    "publish",
    "check",
    "can-i-deploy",
    "users",
    "registry",
    "schema",
    "rule",
    "pull",
    "releases",
    "config",
    "completion",
    "serve",
    "mcp",
    "lsp",
)
"""Names of the commands; each is in the module of its name."""
_MODULES = {"try": "try_overlay", "version-bump": "version_bump", "can-i-deploy": "can_i_deploy"}
"""Modules of commands whose names cannot be names of modules."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit status. Nothing that a user does ends in a traceback."""
    set_up_process()
    reopen_closed_streams()
    with remembering_interrupts():
        return _run(argv)


def _run(argv: Sequence[str] | None) -> int:
    """The exit status of the command, whatever it raises."""
    try:
        if argv is None and "_ARGCOMPLETE" in os.environ:
            _complete()
        given = sys.argv[1:] if argv is None else argv
        arguments = parser_of(given[0] if given else "").parse_args(given)
        refuse_overwriting(arguments)
        status: int = arguments.run(arguments)
        sys.stdout.flush()
    except InputRefused as error:
        from sigcat.cli.output import print_findings

        print_findings(error.findings)
        is_known = error.findings and not isinstance(error, RegistryUnusable)
        return _failed(str(error), 1 if is_known else 2)  # 2: nothing was found out
    except SigcatError as error:
        return _failed(str(error), 2)
    except OSError as error:
        return _not_written(error)
    except KeyboardInterrupt:
        return 130
    except Exception as error:
        if os.environ.get("SIGCAT_DEBUG"):
            raise
        return _broken(error)
    return status


def _complete() -> None:
    """Answer a shell that asks for completions; ends the process."""
    from sigcat.cli.completion import answer, wanted_command

    answer(parser_of(wanted_command()))


def set_up_process() -> None:
    """Spare a short process what a long one may need, and let it print every character."""
    gc.set_threshold(1_000_000, 20)  # most objects of a command live to its end: seldom looked through
    atexit.register(gc.freeze)  # what is left at the end need not be looked through
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # it would look for some in every package installed
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):  # a terminal of another encoding shows escapes
            stream.reconfigure(errors="backslashreplace")


def parser_of(wanted: str) -> CommandParser:
    """The parser of the command `wanted`; of all commands if it is not one, such as `--help`."""
    parser = CommandParser(
        prog="sigcat",
        description="A signal catalogue: browse, lint and export VSS trees with their interfaces, build functions.",
        epilog="Exit status: 0 done, or nothing worse than a note; 1 findings, or changes that --fail-on names; 2 could not run.",
    )
    parser.add_argument("--version", action="version", version=f"sigcat {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", prog="sigcat")
    for name in (wanted,) if wanted in COMMANDS else COMMANDS:
        import_module(f"sigcat.cli.{_MODULES.get(name, name)}").add_parser(commands)
    return parser


def _failed(message: str, status: int) -> int:
    print(f"sigcat: {printable_lines(message)}", file=sys.stderr)
    return status


def _broken(error: Exception) -> int:
    """Report an error of sigcat; 130 if it follows from an interrupt that a library has swallowed."""
    if was_interrupted():
        return 130
    return _failed(f"internal error: {type(error).__name__}: {error} (SIGCAT_DEBUG=1 shows where)", 2)


def _reason(error: OSError) -> str:
    if isinstance(error, IsADirectoryError):
        return must_be_a_file(error.filename)
    return f"{error.filename}: {error.strerror}" if error.filename else str(error.strerror or error)


def _not_written(error: OSError) -> int:
    """The status after a file or the output could not be read or written: a reader that has gone, as `head` does, is no error."""
    has_reader_gone, is_closed = isinstance(error, BrokenPipeError), is_closed_output(error)
    if has_reader_gone or is_closed:
        from sigcat.cli.output import discard_output

        discard_output()
    message = "standard output is closed: the result was not written. Open it, or name a file with -o."
    return 0 if has_reader_gone else _failed(message if is_closed else _reason(error), 2)
