"""`sigcat gateway LOG --dbc DATABASE -l MAPPINGS -o TRACE`, or `--to INTEGRATION` instead of a trace."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.command_parser import positive
from sigcat.cli.output import make_folder, print_findings, write_lines
from sigcat.cli.output_options import FORMATS, add_output
from sigcat.cli.project_options import project_of
from sigcat.cli.reported import reported
from sigcat.cli.tree_options import add_dbc, add_tree_options, read_tree
from sigcat.errors import UsageError, existing_file
from sigcat.temporary_files import temporary_folder

if TYPE_CHECKING:
    from sigcat.findings import Finding
    from sigcat.gateway.carry import FromCan, ToCan, ToFunctions
    from sigcat.players.program import Mode


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "gateway",
        help="convert CAN to a trace, or send it to running functions",
        description=(
            "Decode a CAN log, or frames from a bus. Write the signals that the catalogue maps to them as a trace for "
            "`sigcat simulate`, or send them to running functions over SOME/IP or DDS. This needs "
            "the extra `can`: pip install 'sigcat[can]'."
        ),
    )
    parser.add_argument(
        "log", type=Path, nargs="?", metavar="LOG",
        help=".asc, .blf or candump's .log; also with .gz; with --send a trace (.csv)",
    )  # fmt: skip
    parser.add_argument(
        "--live", metavar="INTERFACE:CHANNEL", help="a bus instead of a log, as python-can names it: socketcan:can0"
    )
    parser.add_argument(
        "--duration", type=positive(float), metavar="SECONDS", help="how long to listen (default: until interrupted)"
    )
    add_dbc(parser, "CAN database (DBC), or CHANNEL=FILE for that of one channel of several")
    parser.add_argument("--channel", metavar="NAME", help="frames of this channel alone, as the log names it")
    parser.add_argument(
        "--j1939", action="store_true",
        help="find messages with extended identifiers by their PGN (SAE J1939), also where the database does not say so",
    )  # fmt: skip
    parser.add_argument(
        "--add", type=Path, metavar="TRACE", help="add the columns of this trace that nothing maps, row by row"
    )
    parser.add_argument("--from-zero", action="store_true", help="count times from the first frame on")
    add_output(parser, "-o", "--output", metavar="TRACE", help="write the trace here (default: standard output)")
    parser.add_argument(
        "--send", metavar="INTERFACE:CHANNEL",
        help="send signals of a trace or of functions, as the catalogue maps them to CAN, to this bus or into a log",
    )  # fmt: skip
    parser.add_argument(
        "--defaults",
        type=Path,
        metavar="FILE",
        help="JSON with what signals of CAN have in frames before a value comes, for --send",
    )
    _add_functions(parser)
    add_output(parser, "--report", metavar="FILE", help="write what is found here, too")
    parser.add_argument("--format", choices=FORMATS, help="form of the report (default: json)")
    add_tree_options(parser)
    parser.set_defaults(run=gateway)


def _add_functions(parser: argparse.ArgumentParser) -> None:
    to = parser.add_argument_group("functions that run")
    to.add_argument(
        "--to", type=Path, metavar="INTEGRATION",
        help="send to the functions of this Integration JSON, at the times of the log: over SOME/IP for AUTOSAR adaptive, over "
        "DDS for ROS 2",
    )  # fmt: skip
    to.add_argument(
        "--lock-step", action="store_true",
        help="run in lock step: as fast as possible, without losing messages",
    )  # fmt: skip
    add_output(to, "--recorded", metavar="TRACE", help="write what the functions send here")
    to.add_argument(
        "--keep",
        type=Path,
        metavar="FOLDER",
        help="keep build files of the sender in FOLDER (default: a temporary folder)",
    )


def gateway(arguments: argparse.Namespace) -> int:
    """Carry, and write a report of the findings if `--report` asks for one."""
    with reported(arguments.report, arguments.format or "json") as found:
        return _gateway(arguments, found)


def _gateway(arguments: argparse.Namespace, found: "list[Finding]") -> int:
    """Write all that can be read; 1 if an error was found on the way."""
    from sigcat.findings import has_errors
    from sigcat.gateway.carry import Outputs, ToCan, carry, send_trace
    from sigcat.gateway.defaults import read_defaults
    from sigcat.gateway.prepare import prepare

    _check(arguments)
    given = None if _is_trace(arguments) else _from_can(arguments, found)
    prepared = prepare(read_tree(arguments), _databases(arguments), is_sending=given is None)
    defaults, doubts = (
        read_defaults(existing_file(arguments.defaults), prepared.database) if arguments.defaults else ({}, ())
    )
    print_findings((*prepared.findings, *doubts))
    found += (*prepared.findings, *doubts)
    told, outputs = len(found), Outputs(write_lines, _tell, found)
    to_can = ToCan(arguments.send, defaults) if arguments.send else None
    if given is not None:
        with _functions(arguments, to_can) as functions:
            lines = carry(given, functions, prepared, outputs)
    elif to_can is not None:
        lines = send_trace(existing_file(arguments.log), to_can, prepared, outputs)
    print_findings(found[told:])
    for line in lines:
        _tell(line)
    return int(has_errors(found))


def _tell(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


def _check(arguments: argparse.Namespace) -> None:
    """Raises UsageError for options that do not belong together."""
    is_trace, is_to = _is_trace(arguments), arguments.to is not None
    misuses: tuple[tuple[object, str], ...] = (
        (
            not (arguments.dbc or project_of(arguments).dbc),
            "name the CAN database: --dbc FILE, or `dbc` in the project file",
        ),
        (arguments.format and arguments.report is None, "--format is for --report: name its file"),
        *(
            (not is_to and given, f"--{name} is for --to: name the Integration JSON of the functions")
            for name, given in (
                ("lock-step", arguments.lock_step), ("recorded", arguments.recorded), ("keep", arguments.keep)
            )
        ),
        (
            arguments.send and not is_to and not is_trace,
            "--send is for a trace (.csv), or for what functions send: name these with --to",
        ),
        (arguments.defaults and not arguments.send, "--defaults is for --send: name a bus or a log"),
        (arguments.lock_step and arguments.live, "--lock-step is for a log: a bus does not wait"),
        (is_trace and (is_to or not arguments.send), "a trace goes to CAN: name a bus or a log with --send"),
        (
            not is_trace and (arguments.log is None) == (arguments.live is None),
            "name a log, or a bus with --live INTERFACE:CHANNEL",
        ),
        (
            not is_trace and arguments.log and arguments.duration,
            "--duration is for --live: a log is read to its end",
        ),
    )  # fmt: skip
    for is_wrong, message in misuses:
        if is_wrong:
            raise UsageError(message)


def _databases(arguments: argparse.Namespace) -> "list[Path | tuple[str, Path]]":
    """Files of databases, or channels with them."""
    found: list[Path | tuple[str, Path]] = []
    for path in arguments.dbc or project_of(arguments).dbc:
        channel, equals, file = str(path).partition("=")
        is_of_channel = bool(equals and channel and "/" not in channel and not path.exists())
        found.append((channel, existing_file(file)) if is_of_channel else existing_file(path))
    return found


def _is_trace(arguments: argparse.Namespace) -> bool:
    from sigcat.gateway.logs.read import is_log

    return arguments.log is not None and arguments.log.suffix.lower() == ".csv" and not is_log(arguments.log)


def _from_can(arguments: argparse.Namespace, found: "list[Finding]") -> "FromCan":
    """The frames of a log or a bus. Raises UsageError."""
    from sigcat.gateway.carry import FromCan
    from sigcat.gateway.live import read_bus
    from sigcat.gateway.logs.read import read_log

    if arguments.log is not None:
        frames, name = read_log(existing_file(arguments.log), found), str(arguments.log)
    else:
        interface, _, channel = arguments.live.partition(":")
        if not (interface and channel):
            raise UsageError(f"--live must be INTERFACE:CHANNEL, such as socketcan:can0, not {arguments.live!r}")
        frames, name = read_bus(interface, channel, arguments.duration), arguments.live
    return FromCan(
        frames=frames,
        name=name,
        channel=arguments.channel,
        is_from_zero=arguments.from_zero or bool(arguments.live) or bool(arguments.to),
        is_j1939=arguments.j1939,
        added=existing_file(arguments.add) if arguments.add else None,
        output=arguments.output,
    )


@contextmanager
def _functions(arguments: argparse.Namespace, to_can: "ToCan | None") -> "Iterator[ToFunctions | None]":
    """The functions to send to, if there are any, and a folder to build in."""
    from sigcat.gateway.carry import ToFunctions

    if arguments.to is None:
        yield None
        return
    if arguments.keep is not None:
        make_folder(arguments.keep)
    with nullcontext(arguments.keep) if arguments.keep else temporary_folder("sigcat-gateway-") as folder:
        mode: Mode = "lock" if arguments.lock_step else "live" if arguments.live else "timed"
        yield ToFunctions(existing_file(arguments.to), Path(folder).absolute(), mode, arguments.recorded, to_can)
