"""The order of calls: what `previous runnable`, priority, offset and run type say together."""

import re
from collections.abc import Iterable, Mapping

from sigcat.function.function_json.model import Runnable, milliseconds

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


def in_circles(following: Mapping[str, Iterable[str]]) -> frozenset[str]:
    """Names that lead back to themselves. Each is visited twice at most, however long the chains are (Kosaraju)."""
    seen: set[str] = set()
    finished = [name for start in following if start not in seen for name in _visited(start, following, seen)]
    before: dict[str, list[str]] = {}
    for name, targets in following.items():
        for target in targets:
            before.setdefault(target, []).append(name)
    seen = set()
    groups = [_visited(start, before, seen) for start in reversed(finished) if start not in seen]
    return frozenset(
        name for group in groups if len(group) > 1 or group[0] in following.get(group[0], ()) for name in group
    )


def _visited(start: str, following: Mapping[str, Iterable[str]], seen: set[str]) -> list[str]:
    """What is reached from a name and was not seen before, each after all that it leads to."""
    seen.add(start)
    done: list[str] = []
    waiting = [(start, iter(following.get(start, ())))]
    while waiting:
        name, rest = waiting[-1]
        step = next((each for each in rest if each not in seen), None)
        if step is None:
            done.append(name)
            waiting.pop()
        else:
            seen.add(step)
            waiting.append((step, iter(following.get(step, ()))))
    return done


def priority_of(runnable: Runnable) -> int | None:
    """The number that a priority means; None for words."""
    return int(runnable.priority) if _NUMBER.fullmatch(runnable.priority) else None
