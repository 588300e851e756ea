"""Functions around each call: its snapshot, its outputs, and the errors that are evaluated with them."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c import errors, inputs, methods, modes, outputs, parameters, schedule, supervision
from sigcat.adapter.core.c.layout import c_functions, text_of
from sigcat.adapter.core.c.lines import TIME, Lines, joined, replaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Call, CorePlan


class _Call(NamedTuple):
    """A call and the statements around it."""

    call: Call
    statement: str
    takes_arrays: bool
    requests_arrays: bool
    closed: str
    reported: str
    before: str
    immediate: str
    ended: str
    given: str
    requested: str
    is_set: Mapping[str, str]


class _Plan(NamedTuple):
    """Plan of the functions; `runs` are conditions, by the names of calls."""

    p: str
    m: str
    plan: CorePlan
    calls: Sequence[_Call]
    measures: bool
    closed: str
    runs: Mapping[str, str]


def call_functions(scope: Scope) -> list[Lines]:
    """The four functions of each call, and Supervise."""
    steps = scope.plan.steps
    plan = _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=scope.plan,
        calls=[_call(call, scope) for call in steps],
        measures=any(call.alive or call.deadline for call in steps),
        closed=_at_now(supervision.closed(scope)),
        runs={call.name: modes.condition(call, scope) for call in steps},
    )
    return c_functions("calls.c.j2", plan)


def _call(call: Call, scope: Scope) -> _Call:
    plan = scope.plan
    return _Call(
        call=call,
        statement=schedule.called(call, scope),
        takes_arrays=methods.takes_arrays(call, scope),
        requests_arrays=methods.requests_arrays(call, scope),
        closed=_at_now(supervision.closed(scope)),
        reported=text_of(supervision.reported(call, scope)),
        before=_at_now(_before(call, scope)),
        immediate=text_of(joined(inputs.taken(call, item, scope) for item in call.inputs if item.is_immediate)),
        ended=_at_now(supervision.ended(call, scope)),
        given=text_of(joined(outputs.given(call, output, scope) for output in call.outputs)),
        requested=_at_now(methods.requested(call, scope)),
        is_set={error.named.name: scope.is_set(error.variable) for error in plan.errors if error.variable},
    )


def _before(call: Call, scope: Scope) -> Lines:
    """The snapshot of a call, and what is evaluated with it."""
    plan = scope.plan
    return joined([
        modes.written(scope),
        *(inputs.judged(call, item, scope) for item in call.inputs),
        *(inputs.taken(call, item, scope) for item in call.inputs if not item.is_immediate),
        *(parameters.written(each, scope) for each in plan.parameters if call.name in each.calls and not each.learned),
        errors.evaluated(plan.errors_of(call.name, late=False), scope),
        *(errors.status_written(error, scope) for error in plan.errors if call.name in error.calls),
        errors.reacted(call.name, scope),
        methods.taken(call, scope),
    ])  # fmt: skip


def _at_now(part: Lines) -> str:
    """Statements at the time that does not go back."""
    return text_of(replaced(TIME, "now", part))
