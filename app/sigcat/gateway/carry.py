"""A run of the gateway: a log or a bus to a trace or to functions, and a trace or what functions send to CAN."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import ExitStack
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from sigcat import codes
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.gateway.bus import open_bus
from sigcat.gateway.doubts import doubts
from sigcat.gateway.frames import Frame, Passed
from sigcat.gateway.prepare import Prepared
from sigcat.gateway.returning import Returning, frames_of
from sigcat.gateway.sending import Sender
from sigcat.gateway.trace import Row, added_trace, clock_doubt, joined, lines_of, merged, rows_of, trace_rows
from sigcat.gateway.translation import Moment, Translation

if TYPE_CHECKING:
    from sigcat.players.player import Hear
    from sigcat.players.program import Mode, Program


class Outputs(NamedTuple):
    """Targets of results while a run lasts."""

    write: Callable[[Iterable[str], Path | None], None]
    """Writes the lines of a trace; None is standard output."""
    tell: Callable[[str], None]
    """Shows a line to the user."""
    findings: list[Finding]
    """Grows while the gateway runs."""


class ToCan(NamedTuple):
    """A target of frames."""

    bus: str
    """INTERFACE:CHANNEL, or a log."""
    defaults: Mapping[str, float | str]
    """Values of signals before one is received."""


class ToFunctions(NamedTuple):
    """Functions that run."""

    integration: Path
    folder: Path
    """Folder in which their player is built."""
    mode: "Mode"
    recorded: Path | None
    """The trace of the values that they send."""
    to_can: ToCan | None


class FromCan(NamedTuple):
    """Frames, and how they become a trace."""

    frames: Iterator[Frame | Passed]
    name: str
    """The log or the bus in findings."""
    channel: str | None
    is_from_zero: bool
    is_j1939: bool
    added: Path | None
    """A trace whose columns are added."""
    output: Path | None


def send_trace(trace: Path, to: ToCan, prepared: Prepared, outputs: Outputs) -> Iterable[str]:
    """Send what a trace has to CAN. Returns a line about it."""
    rows, columns = trace_rows(trace)
    sender = Sender(prepared.database, prepared.outgoing, to.defaults)
    with open_bus(to.bus) as bus:
        bus.send_at_times(frames_of(rows, columns, sender))
    outputs.findings.extend(sender.findings(str(trace)))
    return (f"{trace}: {sender.line()}",)


def carry(given: FromCan, to: ToFunctions | None, prepared: Prepared, outputs: Outputs) -> Iterable[str]:
    """Decode frames to a trace, or send them to functions. Returns lines about the decoded frames."""
    translation = Translation(
        prepared.database, prepared.mapped, given.channel, is_from_zero=given.is_from_zero, is_j1939=given.is_j1939
    )
    moments = translation.moments(given.frames, given.name)
    if to is not None:
        _to_functions(given, to, _rows(given, prepared, translation, moments, outputs), prepared, outputs)
    elif (first := next(moments, None)) is not None:  # a log that yields nothing replaces no trace
        rows, columns = _rows(given, prepared, translation, chain((first,), moments), outputs)
        outputs.write(lines_of(joined(rows), columns), given.output)
    outputs.findings.extend((*translation.findings, *_clock_doubts(given, translation)))
    outputs.findings.extend(doubts(translation, given.name, outputs.findings))
    return [f"{given.name}: {line}" for line in translation.counts.lines()]


_Trace = tuple[Iterator[Row], tuple[str, ...]]
"""Rows and columns."""


def _rows(
    given: FromCan, prepared: Prepared, translation: Translation, moments: Iterable[Moment], outputs: Outputs
) -> _Trace:
    columns = tuple(each.name for each in translation.mapped)
    rows = rows_of(moments)
    if given.added is None:
        return rows, columns
    added = added_trace(given.added, translation.mapped, prepared.datatypes)
    outputs.findings.extend(added.findings)
    return merged(rows, added, len(columns)), (*columns, *added.columns)


def _clock_doubts(given: FromCan, translation: Translation) -> Iterator[Finding]:
    """Whether an added trace has another clock than the log."""
    first = translation.counts.first
    if given.added is not None and first is not None:
        doubt = clock_doubt(added_trace(given.added, ()), 0 if translation.is_from_zero else first)
        if doubt is not None:
            yield doubt


def _to_functions(given: FromCan, to: ToFunctions, trace: _Trace, prepared: Prepared, outputs: Outputs) -> None:
    """Send to functions, and write what they send."""
    from sigcat.gateway.onward import Handed, Heard
    from sigcat.players.player import Player, PlayerEnded
    from sigcat.runs.recording.normalized import TIME_NS, normalized_line

    rows, columns = trace
    with ExitStack() as stack:
        program = _program(to)
        handed, heard = Handed(columns, program), Heard()
        sender, returning = None, None
        takers: list[Hear] = [heard.take]
        if to.to_can is not None:
            sender = Sender(prepared.database, prepared.outgoing, to.to_can.defaults)
            bus = stack.enter_context(open_bus(to.to_can.bus))
            is_lock_step = to.mode == "lock"
            returning = Returning(sender, bus, lambda text: outputs.tell(f"sigcat: {text}"), is_lock_step=is_lock_step)
            takers.append(stack.enter_context(returning).take)
        player = stack.enter_context(Player(program, to.mode, takers))
        try:
            player.begin(normalized_line(TIME_NS, columns))
            lines = lines_of(handed.given(player, rows if to.mode == "live" else joined(rows)), columns)
            outputs.write(lines, given.output) if given.output else deque(lines, maxlen=0)
        except PlayerEnded as ended:
            fix = "Start them before the gateway, on this machine, as their pages say."
            outputs.findings.append(codes.FUNCTIONS_UNREACHED.finding(str(ended), str(to.integration), fix=fix))
            return
        outputs.findings.extend(handed.findings(player, given.name))
        if sender is not None and returning is not None:
            returning.close()
            outputs.findings.extend((*sender.findings(given.name), *returning.findings(given.name)))
            outputs.tell(f"{given.name}: {sender.line()}")
        outputs.tell(f"{given.name}: {handed.line(player)}, {heard.count:,} received")
        if to.recorded is not None:
            outputs.write(lines_of(joined(heard.rows()), tuple(heard.columns)), to.recorded)


def _program(to: ToFunctions) -> "Program":
    """The player, built. Raises UsageError with what a compiler says."""
    from sigcat.players.commands import BuildFails
    from sigcat.players.program import build_player

    try:
        return build_player(to.integration.read_bytes(), str(to.integration), to.folder)
    except BuildFails as failed:
        raise UsageError(f"what sends to the functions cannot be built: {failed}") from None
