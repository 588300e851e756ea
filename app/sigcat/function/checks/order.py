"""The order of calls: what `previous runnable`, priority, offset and run type say together."""

import re

from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.runnable import Runnable

_PHASES = {"Init": 0, "Cyclic": 1, "EventTriggered": 1, "Shutdown": 2}
_NUMBER = re.compile(r"\s*[+-]?\d{1,18}\s*")


def previous_calls(runnable: Runnable) -> tuple[str, ...]:
    """Names of the calls after which a call runs; the wire format has one text for them."""
    names = (name.strip() for name in (runnable.previous_runnable or "").split(","))
    return tuple(name for name in names if name)


def contradiction(runnable: Runnable, previous: Runnable) -> str:
    """Why a call cannot run after another one, as the rest of a sentence; nothing if it can."""
    phase, phase_before = _PHASES.get(runnable.run_type), _PHASES.get(previous.run_type)
    if phase is not None and phase_before is not None and phase < phase_before:
        return f"but its run type is {runnable.run_type}, and that of {previous.name} is {previous.run_type}"
    if not runnable.cycle_time or runnable.cycle_time != previous.cycle_time:
        return ""
    offset, offset_before = (milliseconds(call.execution_offset) or 0 for call in (runnable, previous))
    if offset != offset_before:
        return f"but starts {offset_before - offset:g} ms before it in every cycle" if offset < offset_before else ""
    priority, priority_before = priority_of(runnable), priority_of(previous)
    if priority is not None and priority_before is not None and priority > priority_before:
        return f"but its priority {priority} is above {priority_before}, so that it runs first"
    return ""


def priority_of(runnable: Runnable) -> int | None:
    """The number that a priority means; None for words."""
    return int(runnable.priority) if _NUMBER.fullmatch(runnable.priority) else None
