"""Calls that run in one thread: those of a priority, and those that would disturb each other."""

from collections.abc import Iterable, Mapping
from itertools import combinations

from sigcat.adapter.autosar_adaptive.application.plan import CallThread, Joined
from sigcat.adapter.core.plan import CLASS, Call, CorePlan, Input, Output
from sigcat.integration.autosar_adaptive import model


def threads_of(core: CorePlan, joined: Iterable[Joined]) -> tuple[CallThread, ...]:
    """The threads of a component, the most urgent one first."""
    groups: list[list[Call]] = [[step] for step in core.due]
    pairs = {frozenset((each.first, each.second)) for each in joined}
    for one, other in combinations(core.due, 2):
        if one.priority == other.priority or frozenset((one.interface, other.interface)) in pairs:
            _join(groups, one, other)
    in_order = [tuple(step for step in core.due if step in group) for group in groups]
    found = sorted(((max(step.priority for step in group), group) for group in in_order), key=lambda each: -each[0])
    return tuple(CallThread(number, priority, group) for number, (priority, group) in enumerate(found))


def joined_calls(core: CorePlan, calls: Iterable[model.Call]) -> tuple[Joined, ...]:
    """Calls of different priorities that must not run at the same time, with the reason."""
    declared = {call.name: call for call in calls}
    pairs = ((one, other) for one, other in combinations(core.due, 2) if one.priority != other.priority)
    found = (Joined(one.interface, other.interface, _reason(one, other, core, declared)) for one, other in pairs)
    return tuple(each for each in found if each.reason)


def _join(groups: list[list[Call]], one: Call, other: Call) -> None:
    kept = next(group for group in groups if one in group)
    taken = next(group for group in groups if other in group)
    if kept is not taken:
        kept += taken
        groups.remove(taken)


def _reason(one: Call, other: Call, core: CorePlan, declared: Mapping[str, model.Call]) -> str:
    low = min(one, other, key=lambda step: step.priority)
    if (call := declared.get(low.interface)) and call.scheduling == "Non-preemptive":
        return f"{low.interface} is not preemptive"
    if all((call := declared.get(each.interface)) and call.parallel_processing for each in (one, other)):
        return ""
    return _shared(one, other, core)


def _shared(one: Call, other: Call, core: CorePlan) -> str:
    """Words for what both calls use of the function's code."""
    if core.code.signature == CLASS:
        return "both are functions of one object"
    if objects := [name for name in one.arguments if name in other.arguments]:
        return f"both take {objects[0]}"
    ours, theirs = variables_of(one, core), variables_of(other, core)
    variable = next((each for each in ours if any(_overlap(each, their) for their in theirs)), None)
    return f"both use {variable}" if variable else ""


def _overlap(one: str, other: str) -> bool:
    """Whether one of two variables is the other, or is in it."""
    short, long = sorted((one, other), key=len)
    return long.startswith(short) and long[len(short) : len(short) + 1] in ("", ".", "[", "-")


def variables_of(call: Call, core: CorePlan) -> tuple[str, ...]:
    """Variables that the call, or the core around it, reads or writes."""
    data: list[Input | Output] = [*call.inputs, *call.outputs]
    methods = [method for method in core.methods if method.call == call.name and not method.is_offered]
    found = [
        *(each.variable for each in data),
        *(each.queue.count_variable for each in data if each.queue),
        *(each.variable for each in core.parameters if call.name in each.calls),
        *(name for each in core.errors if call.name in each.calls for name in (each.variable, each.status_variable)),
        *(each.variable for each in core.reactions if call.name in each.calls),
        *(name for each in methods for name in (each.request_variable, each.status_variable)),
        *(part.variable for each in methods for part in (*each.arguments, *each.results)),
        *(mode.variable for mode in (core.mode_in, core.mode_out) if mode),
    ]
    return tuple(dict.fromkeys(name for name in found if name))
