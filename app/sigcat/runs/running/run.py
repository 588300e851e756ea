"""A run in progress, and why it stopped if it did."""

import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat.runs.running.process import Damaged, Ended, Hangs, Limits, PrintsTooMuch, results
from sigcat.runs.running.rows import Event, Finished, Garbled, Layout, NoEnd, Progress, Scan, events

Reason = Literal["crashes", "hangs", "no end", "garbled", "prints too much"]


class Command(NamedTuple):
    """A program, and what it is given."""

    program: tuple[str, ...]
    """With what it is started by, such as a sandbox."""
    input: Path
    results: Path
    start: int
    end: int
    """In ns."""
    ignition_cycle: int
    echoes: bool
    """Whether results have what is received, too."""
    memory: int
    """Bytes that it may allocate."""
    limits: Limits
    prints: Path | None = None
    """A file for what functions print; None: it goes where our errors go."""
    is_sandboxed: bool = False
    """Whether another program starts it, whose status says by which signal it ended."""

    @property
    def arguments(self) -> tuple[str, ...]:
        """Words that start the process."""
        times = (str(self.start), str(self.end), str(self.ignition_cycle))
        bounds = (str(int(self.echoes)), str(self.memory), str(self.limits.printed))
        return (*self.program, str(self.input), str(self.results), *times, *bounds)


class Stopped(Exception):
    """Why a run did not come to its end."""

    def __init__(self, reason: Reason, begun: int | None, time: int, how: str = "") -> None:
        super().__init__(reason)
        self.reason: Reason = reason
        self.begun = begun
        """Number of the call that did not return; None if the process ended between calls."""
        self.time = time
        self.how = how
        """As text: the signal, the status, or the damage of the results."""


def run(command: Command, layout: Layout, scan: Scan, progress: Progress) -> Iterator[Event]:
    """Events of a run. Raises Stopped if it does not come to its end."""
    is_finished = False
    try:
        pieces = results(command.arguments, command.results, command.limits, command.prints)
        for event in events(pieces, layout, scan, progress):
            if isinstance(event, NoEnd):
                raise Stopped("no end", None, event.time)
            is_finished = is_finished or isinstance(event, Finished)
            yield event  # the process continues to its end: it still writes its measurements
    except (Damaged, Ended, Garbled, Hangs, PrintsTooMuch) as stopped:
        if not is_finished:
            raise _stopped(_unpacked(stopped, command), progress, command.start) from None
    if not is_finished:
        raise _stopped(Ended(0), progress, command.start)


def _unpacked(why: Exception, command: Command) -> Exception:
    """The reason without the sandbox: its status says by which signal the program ended."""
    if command.is_sandboxed and isinstance(why, Ended) and why.status > _SIGNAL:
        return Ended(_SIGNAL - why.status)
    return why


_SIGNAL = 128
"""A status above it is a signal."""


def _stopped(why: Exception, progress: Progress, start: int) -> Stopped:
    begun = progress.begun[0] if progress.begun else None
    time = start if progress.time is None else progress.time
    if isinstance(why, Garbled | Damaged):
        return Stopped("garbled", None, time, str(why) or "their place was written over")
    if isinstance(why, PrintsTooMuch):
        return Stopped("prints too much", begun, time)
    if isinstance(why, Ended):
        return Stopped("crashes", begun, time, _as_text(why.status))
    return Stopped("hangs", begun, time)


def _as_text(status: int) -> str:
    """Return how a process ended, as text: `SIGSEGV (Segmentation fault)`."""
    if status >= 0:
        return f"exit status {status}"
    try:
        name = signal.Signals(-status).name
    except ValueError:
        return f"signal {-status}"
    return f"{name} ({signal.strsignal(-status)})"
