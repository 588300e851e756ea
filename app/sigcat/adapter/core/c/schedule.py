"""When calls are due (section 9), and what surrounds each of them."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c import modes
from sigcat.adapter.core.c.layout import c_functions
from sigcat.adapter.core.c.lines import Lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import CLASS, Call, CorePlan


class _Call(NamedTuple):
    """A call, and the conditions that it is due, that it waits for others, and that the mode lets it run."""

    step: Call
    when: str
    is_due: str
    waits: str
    runs: str


class _Plan(NamedTuple):
    p: str
    m: str
    plan: CorePlan
    calls: Sequence[_Call]
    due: Sequence[_Call]
    closes: bool


def enter_functions(scope: Scope) -> list[Lines]:
    """Clocks and windows that start again."""
    return c_functions("enter.c.j2", _plan(scope))


def due_functions(scope: Scope) -> list[Lines]:
    """Find the call that is due."""
    return c_functions("schedule.c.j2", _plan(scope))


def _plan(scope: Scope) -> _Plan:
    plan = scope.plan
    calls = {call.name: _call(call, scope) for call in plan.steps}
    return _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=plan,
        calls=list(calls.values()),
        due=[calls[call.name] for call in plan.due],
        closes=any(call.alive for call in plan.steps),
    )


def _call(call: Call, scope: Scope) -> _Call:
    when = f"every {call.cycle / 10**6:g} ms" if call.cycle is not None else "when its signals are received"
    is_due = " && ".join(_conditions(call, scope))
    return _Call(call, when, is_due, _waits(call, scope), modes.condition(call, scope))


def _previous(call: Call, scope: Scope) -> list[Call]:
    return [step for step in scope.plan.steps if step.name in call.previous and step.name != call.name]


def _excluding(call: Call, scope: Scope) -> list[Call]:
    """Calls that do not run at the same time as this one."""
    others = (step for step in scope.plan.steps if step.name != call.name)
    return [step for step in others if call.is_exclusive or step.is_exclusive]


def _waits(call: Call, scope: Scope) -> str:
    conditions = [f"self->{other.name}.is_active" for other in _excluding(call, scope)]
    for other in _previous(call, scope):
        runs = modes.condition(other, scope)
        ended = f"!self->{other.name}.has_ended"
        conditions.append(ended if runs == "true" else f"({ended} && {runs})")
    return " || ".join(conditions)


def _conditions(call: Call, scope: Scope) -> list[str]:
    place = f"self->{call.name}"
    runs = modes.condition(call, scope)
    when = f"(t >= {place}.release)" if call.cycle is not None else f"({place}.events > 0U)"
    rested = f"(!{place}.has_begun || ((t - {place}.begun) >= {time(call.debounce)}))" if call.debounce else ""
    waits = f"!{scope.prefix}_Waits_{call.name}(self)" if _waits(call, scope) else ""
    return [each for each in ("" if runs == "true" else runs, when, f"!{place}.is_active", rested, waits) if each]


def called(call: Call, scope: Scope) -> str:
    """The call itself."""
    arguments = ", ".join(f"&self->code.{name}" for name in call.arguments)
    at = "self->object." if scope.plan.code.signature == CLASS else ""
    return f"{at}{call.symbol}({arguments})"
