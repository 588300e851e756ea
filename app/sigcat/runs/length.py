"""Length of a run, in calls. A mistyped time that makes it too long is refused before it begins."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.adapter.host.connections import Member
from sigcat.errors import InputRefused, UsageError
from sigcat.limits import RUN_CALLS
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import Trace


def check_length(members: Sequence[Member], start: int, end: int, trace: Trace | None, line: int | None) -> None:
    """Raises InputRefused at the line of the trace that makes it so long, UsageError where a duration does."""
    calls = cyclic_calls(members, end - start)
    if calls <= RUN_CALLS:
        return
    said = f"A run from {seconds(start)} s to {seconds(end)} s has {calls:,} cyclic calls; it must have at most {RUN_CALLS:,}"
    if trace is None or line is None:
        raise UsageError(f"{said[0].lower()}{said[1:]}: give a shorter duration")
    fix = "Correct the time, or pass `--duration` with the length of the run."
    finding = codes.RUN_TOO_LONG.finding(f"{said}.", *trace.place(line, 1), fix=fix)
    raise InputRefused("The run would be too long.", (finding,))


def cyclic_calls(members: Sequence[Member], duration: int) -> int:
    """Return how often the calls of functions are due in so many ns."""
    cycles = [step.cycle for member in members for step in member.plan.steps if step.cycle]
    return sum(duration // cycle for cycle in cycles)
