"""`sigcat gateway LOG --dbc DATABASE -l MAPPINGS -o TRACE`, or `--to INTEGRATION` instead of a trace."""

import argparse
import sys
from contextlib import ExitStack
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
    from collections.abc import Iterable, Iterator, Mapping

    from sigcat.findings import Finding
    from sigcat.gateway.frames import Frame, Passed
    from sigcat.gateway.prepare import Prepared
    from sigcat.gateway.returning import Returning
    from sigcat.gateway.sending import Sender
    from sigcat.gateway.trace import Row
    from sigcat.gateway.translation import Moment, Translation
    from sigcat.players.program import Mode, Program


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
    from itertools import chain

    from sigcat.findings import has_errors
    from sigcat.gateway.doubts import doubts
    from sigcat.gateway.prepare import prepare
    from sigcat.gateway.trace import joined, lines_of
    from sigcat.gateway.translation import Translation

    _check(arguments)
    if _is_trace(arguments):
        return _send_trace(arguments, found)
    frames, name = _frames(arguments, found)
    prepared = prepare(read_tree(arguments), _databases(arguments))
    print_findings(prepared.findings)
    found += prepared.findings
    translation = Translation(
        prepared.database,
        prepared.mapped,
        arguments.channel,
        is_from_zero=arguments.from_zero or bool(arguments.live) or bool(arguments.to),
        is_j1939=arguments.j1939,
    )
    told = len(found)
    moments = translation.moments(frames, name)
    if arguments.to is None:
        first = next(moments, None)
        if first is not None:  # a log that yields nothing replaces no trace
            rows, columns = _rows(arguments, prepared, translation, chain((first,), moments), found)
            write_lines(lines_of(joined(rows), columns), arguments.output)
    else:
        _to_functions(arguments, prepared, translation, moments, found, name)
    found += [*translation.findings, *_clock_doubts(arguments, translation), *doubts(translation, name, found)]
    print_findings(found[told:])
    for line in translation.counts.lines():
        print(f"{name}: {line}", file=sys.stderr)
    return int(has_errors(found))


def _check(arguments: argparse.Namespace) -> None:
    """Raises UsageError for options that do not belong together."""
    if not (arguments.dbc or project_of(arguments).dbc):
        raise UsageError("name the CAN database: --dbc FILE, or `dbc` in the project file")
    if arguments.format is not None and arguments.report is None:
        raise UsageError("--format is for --report: name its file")
    if arguments.to is None:
        given = [name for name in ("lock_step", "recorded", "keep") if getattr(arguments, name)]
        if given:
            raise UsageError(f"--{given[0].replace('_', '-')} is for --to: name the Integration JSON of the functions")
        if arguments.send and not _is_trace(arguments):
            raise UsageError("--send is for a trace (.csv), or for what functions send: name these with --to")
    if arguments.defaults is not None and not arguments.send:
        raise UsageError("--defaults is for --send: name a bus or a log")
    if arguments.lock_step and arguments.live:
        raise UsageError("--lock-step is for a log: a bus does not wait")


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


# -- to CAN -------------------------------------------------------------------------------------------------------


def _send_trace(arguments: argparse.Namespace, found: "list[Finding]") -> int:
    """Send what a trace has; 1 if an error was found on the way."""
    from sigcat.findings import has_errors
    from sigcat.gateway.bus import open_bus
    from sigcat.gateway.prepare import prepare
    from sigcat.gateway.returning import frames_of
    from sigcat.gateway.sending import Sender
    from sigcat.gateway.trace import trace_rows

    if not arguments.send or arguments.to is not None:
        raise UsageError("a trace goes to CAN: name a bus or a log with --send")
    prepared = prepare(read_tree(arguments), _databases(arguments), is_sending=True)
    print_findings(prepared.findings)
    rows, columns = trace_rows(existing_file(arguments.log))
    sender = Sender(prepared.database, prepared.outgoing, _defaults(arguments, prepared, found))
    with open_bus(arguments.send) as bus:
        bus.send_at_times(frames_of(rows, columns, sender))
    told = [*sender.findings(str(arguments.log))]
    print_findings(told)
    print(f"{arguments.log}: {sender.line()}", file=sys.stderr)
    found += [*prepared.findings, *told]
    return int(has_errors(found))


def _defaults(
    arguments: argparse.Namespace, prepared: "Prepared", found: "list[Finding]"
) -> "Mapping[str, float | str]":
    """Default values of signals of CAN, if a file is named."""
    from sigcat.gateway.defaults import read_defaults

    if arguments.defaults is None:
        return {}
    values, findings = read_defaults(existing_file(arguments.defaults), prepared.database)
    print_findings(findings)
    found += findings
    return values


def _returning(
    arguments: argparse.Namespace, prepared: "Prepared", stack: ExitStack, found: "list[Finding]"
) -> "tuple[Sender, Returning | None]":
    """Return the sender of the functions' values to CAN, if it is asked for."""
    from sigcat.gateway.bus import open_bus
    from sigcat.gateway.returning import Returning
    from sigcat.gateway.sending import Sender

    sender = Sender(prepared.database, prepared.outgoing, _defaults(arguments, prepared, found))
    if not arguments.send:
        return sender, None
    bus = stack.enter_context(open_bus(arguments.send))
    return sender, stack.enter_context(Returning(sender, bus, _report, is_lock_step=arguments.lock_step))


def _report(message: str) -> None:
    print(f"sigcat: {message}", file=sys.stderr, flush=True)


# -- functions that run -------------------------------------------------------------------------------------------


def _to_functions(
    arguments: argparse.Namespace,
    prepared: "Prepared",
    translation: "Translation",
    moments: "Iterable[Moment]",
    found: "list[Finding]",
    name: str,
) -> None:
    """Send to functions, and write what they send; their errors are added to `found`."""
    from sigcat import codes
    from sigcat.gateway.heard import Heard
    from sigcat.gateway.onward import Handed
    from sigcat.gateway.trace import joined, lines_of
    from sigcat.players.player import Player, PlayerEnded
    from sigcat.runs.recording.normalized import TIME_NS, normalized_line

    with ExitStack() as stack:
        program = _program(arguments, stack)
        rows, columns = _rows(arguments, prepared, translation, moments, found)
        handed, heard = Handed(columns, program), Heard()
        sender, returning = _returning(arguments, prepared, stack, found)
        takers = [heard.take] if returning is None else [heard.take, returning.take]
        player = stack.enter_context(Player(program, _mode(arguments), takers))
        rows = rows if arguments.live else joined(rows)
        try:
            player.begin(normalized_line(TIME_NS, columns))
            _drain(lines_of(handed.given(player, rows), columns), arguments.output)
        except PlayerEnded as ended:
            fix = "Start them before the gateway, on this machine, as their pages say."
            found.append(codes.FUNCTIONS_UNREACHED.finding(str(ended), str(arguments.to), fix=fix))
            return
        found += handed.findings(player, name)
        if returning is not None:
            returning.close()
            found += [*sender.findings(name), *returning.findings(name)]
            print(f"{name}: {sender.line()}", file=sys.stderr)
        print(f"{name}: {handed.line(player)}, {heard.count:,} received", file=sys.stderr)
        if arguments.recorded is not None:
            write_lines(lines_of(joined(heard.rows()), tuple(heard.columns)), arguments.recorded)


def _mode(arguments: argparse.Namespace) -> "Mode":
    return "lock" if arguments.lock_step else "live" if arguments.live else "timed"


def _program(arguments: argparse.Namespace, stack: ExitStack) -> "Program":
    """The player, built. Raises UsageError with what a compiler says."""
    from sigcat.players.commands import BuildFails
    from sigcat.players.program import build_player

    file = existing_file(arguments.to)
    folder = arguments.keep
    if folder is None:
        folder = stack.enter_context(temporary_folder("sigcat-gateway-"))
    else:
        make_folder(folder)
    try:
        return build_player(file.read_bytes(), str(file), Path(folder).absolute())
    except BuildFails as failed:
        raise UsageError(f"what sends to the functions cannot be built: {failed}") from None


def _drain(lines: "Iterable[str]", output: Path | None) -> None:
    """Take all lines, and write them where a file is named."""
    if output is not None:
        write_lines(lines, output)
        return
    for _ in lines:
        pass


def _frames(arguments: argparse.Namespace, found: "list[Finding]") -> "tuple[Iterator[Frame | Passed], str]":
    """The frames, and what findings call where they come from. Raises UsageError."""
    from sigcat.gateway.live import read_bus
    from sigcat.gateway.logs.read import read_log

    if (arguments.log is None) == (arguments.live is None):
        raise UsageError("name a log, or a bus with --live INTERFACE:CHANNEL")
    if arguments.log is not None:
        if arguments.duration is not None:
            raise UsageError("--duration is for --live: a log is read to its end")
        return read_log(existing_file(arguments.log), found), str(arguments.log)
    interface, _, channel = arguments.live.partition(":")
    if not (interface and channel):
        raise UsageError(f"--live must be INTERFACE:CHANNEL, such as socketcan:can0, not {arguments.live!r}")
    return read_bus(interface, channel, arguments.duration), arguments.live


def _rows(
    arguments: argparse.Namespace,
    prepared: "Prepared",
    translation: "Translation",
    moments: "Iterable[Moment]",
    found: "list[Finding]",
) -> "tuple[Iterator[Row], tuple[str, ...]]":
    """The rows of the trace, and its columns."""
    from sigcat.gateway.trace import added_trace, merged, rows_of

    columns = tuple(each.name for each in translation.mapped)
    rows = rows_of(moments)
    if arguments.add is None:
        return rows, columns
    added = added_trace(existing_file(arguments.add), translation.mapped, prepared.datatypes)
    found += added.findings
    return merged(rows, added, len(columns)), (*columns, *added.columns)


def _clock_doubts(arguments: argparse.Namespace, translation: "Translation") -> "Iterator[Finding]":
    """Whether an added trace has another clock than the log."""
    from sigcat.gateway.trace import added_trace, clock_doubt

    first = translation.counts.first
    if arguments.add is not None and first is not None:
        doubt = clock_doubt(added_trace(arguments.add, ()), 0 if translation.is_from_zero else first)
        if doubt is not None:
            yield doubt
