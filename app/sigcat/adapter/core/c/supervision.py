"""Alive, deadline and logical supervision (section 10)."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c import modes
from sigcat.adapter.core.c.layout import c_functions
from sigcat.adapter.core.c.lines import Lines, block, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Alive, Call, CorePlan, Logical


class _Checkpoint(NamedTuple):
    """A call in the graph, and the condition that it may follow the last one."""

    call: Call
    follows: str


class _Plan(NamedTuple):
    """Plan of windows and checkpoints; `windows` are comments and `runs` conditions, by the names of calls."""

    p: str
    m: str
    plan: CorePlan
    watched: Sequence[Call]
    windows: Mapping[str, str]
    runs: Mapping[str, str]
    checkpoints: Sequence[_Checkpoint]


def supervision_functions(scope: Scope) -> list[Lines]:
    """Windows in which the ends of a call are counted, and a function for each call that is in the graph."""
    watched = [(call, call.alive) for call in scope.plan.steps if call.alive]
    plan = _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=scope.plan,
        watched=[call for call, _ in watched],
        windows={call.name: _limits(call, alive) for call, alive in watched},
        runs={call.name: modes.condition(call, scope) for call, _ in watched},
        checkpoints=[_Checkpoint(call, _follows(call.logical)) for call in scope.plan.calls if call.logical],
    )
    return c_functions("supervision.c.j2", plan)


def _limits(call: Call, alive: Alive) -> str:
    return f"{call.interface} ends {alive.least} to {alive.most} times in each {alive.window / 10**6:g} ms."


def _follows(logical: Logical) -> str:
    numbers = [*logical.previous, *([0] if logical.is_initial else [])]
    conditions = [f"self->checkpoint.active == {number}U" for number in numbers]
    return "".join(conditions) if len(conditions) < 2 else " || ".join(f"({each})" for each in conditions)


def closed(scope: Scope) -> Lines:
    """Windows that are over by now."""
    return lines(f"{scope.prefix}_CloseWindows(self, t);") if any(call.alive for call in scope.plan.steps) else ()


# -- checkpoints --------------------------------------------------------------------------------------------------


def reported(call: Call, scope: Scope) -> Lines:
    """The checkpoint of a call."""
    return lines(f"{scope.prefix}_Report_{call.name}(self);") if call.logical else ()


# -- alive and deadline -------------------------------------------------------------------------------------------


def ended(call: Call, scope: Scope) -> Lines:
    """The end of a call: in its window, and within its deadline."""
    place = f"self->{call.name}"
    found: list[Lines] = []
    if call.alive:
        runs = modes.condition(call, scope)
        counts = " && ".join([*([] if runs == "true" else [runs]), f"(t >= {place}.alive.window)"])
        found.append(block(f"if ({counts})" if " && " in counts else f"if {counts}", [lines(f"{place}.alive.ends++;")]))
    if call.deadline:
        took = f"(t - {place}.begun)"
        late, early = f"({took} > {time(call.deadline.most)})", f"({took} < {time(call.deadline.least)})"
        is_bad = f"({early} || {late})" if call.deadline.least else late
        judged = lines(f"{place}.deadline = {is_bad} ? {scope.present} : {scope.absent};")
        found.append(block(f"if ({place}.is_running)", [judged]))
    return joined(found)
