"""The order of calls: what `previous runnable`, priority, offset and run type say together."""

from typing import NamedTuple

from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.runnable import Runnable

_PHASES = {"Init": 0, "Cyclic": 1, "EventTriggered": 1, "Shutdown": 2}


def previous_calls(runnable: Runnable) -> tuple[str, ...]:
    """Names of the calls after which a call runs; the wire format has one text for them."""
    names = (name.strip() for name in (runnable.previous_runnable or "").split(","))
    return tuple(name for name in names if name)


class Contradiction(NamedTuple):
    """Why a call cannot run after another one, and what to do."""

    message: str
    fix: str


def contradiction(runnable: Runnable, previous: Runnable) -> Contradiction | None:
    """Return the reason why a call cannot run after another one, if there is any."""
    name = runnable.name
    phase, phase_before = _PHASES.get(runnable.run_type), _PHASES.get(previous.run_type)
    if phase is not None and phase_before is not None and phase < phase_before:
        message = f"{name} must not run after {previous.name}: {runnable.run_type} comes before {previous.run_type}."
        return Contradiction(message, "Remove it as the previous call.")
    if not runnable.cycle_time or runnable.cycle_time != previous.cycle_time:
        return None
    offset, offset_before = (milliseconds(call.execution_offset) or 0 for call in (runnable, previous))
    if offset < offset_before:
        message = f"The offset of {name} must be at least {offset_before:g} ms, that of {previous.name}, after which it runs, not {offset:g} ms."
        return Contradiction(message, "Start it later, or remove the previous call.")
    return _above(runnable, previous) if offset == offset_before else None


def _above(runnable: Runnable, previous: Runnable) -> Contradiction | None:
    """A higher priority runs first."""
    priority, priority_before = runnable.priority_number, previous.priority_number
    if priority is not None and priority_before is not None and priority > priority_before:
        message = f"The priority of {runnable.name} must be at most {priority_before}, that of {previous.name}, after which it runs, not {priority}."
        return Contradiction(message, "Lower it, or remove the previous call.")
    return None
