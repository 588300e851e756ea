"""A run as it goes on, and why it stopped if it did."""

import signal
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat.runs.recording.shapes import Packing
from sigcat.runs.running.process import Ended, Hangs, told
from sigcat.runs.running.rows import Begins, Event, Finished, NoEnd, Returns, events

Reason = Literal["crashes", "hangs", "no end"]


class Command(NamedTuple):
    """A program, and what it is given."""

    program: Path
    input: Path
    start: int
    end: int
    """In ns."""
    ignition_cycle: int
    step_limit: float
    """Seconds that a call may take."""
    prints: Path | None = None
    """A file for what functions print; None: it goes where our errors go."""

    @property
    def arguments(self) -> tuple[str, ...]:
        """What the process is started with."""
        return (str(self.program), str(self.input), str(self.start), str(self.end), str(self.ignition_cycle))


class Stopped(Exception):
    """Why a run did not come to its end."""

    def __init__(self, reason: Reason, begun: Begins | None, time: int, how: str = "") -> None:
        super().__init__(reason)
        self.reason: Reason = reason
        self.begun = begun
        """The call that did not return; None if the process ended between calls."""
        self.time = time
        self.how = how
        """In words: the signal, or the status."""


def run(command: Command, exits: Sequence[Packing], kept: Sequence[Packing]) -> Iterator[Event]:
    """What happens in a run. Raises Stopped if it does not come to its end."""
    begun: Begins | None = None
    time = command.start
    is_finished = False
    try:
        for event in events(told(command.arguments, command.step_limit, command.prints), exits, kept):
            if isinstance(event, Begins):
                begun, time = event, event.time
            elif isinstance(event, Returns):
                begun = None
            elif isinstance(event, NoEnd):
                raise Stopped("no end", None, event.time)
            elif isinstance(event, Finished):
                is_finished = True  # the process goes on to its end: it still writes what was measured
            yield event
    except (Hangs, Ended) as stopped:
        if not is_finished:
            raise _stopped(stopped, begun, time) from None
    if not is_finished:
        raise Stopped("crashes", begun, time, _in_words(0))


def _stopped(why: Hangs | Ended, begun: Begins | None, time: int) -> Stopped:
    if isinstance(why, Ended):
        return Stopped("crashes", begun, time, _in_words(why.status))
    return Stopped("hangs", begun, time)


def _in_words(status: int) -> str:
    """How a process ended: `SIGSEGV (Segmentation fault)`."""
    if status >= 0:
        return f"exit status {status}"
    try:
        name = signal.Signals(-status).name
    except ValueError:
        return f"signal {-status}"
    return f"{name} ({signal.strsignal(-status)})"
