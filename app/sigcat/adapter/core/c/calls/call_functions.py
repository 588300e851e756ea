"""Calls, and what is done before and after each."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.calls.methods import MethodPlan, method_plan
from sigcat.adapter.core.c.data.inputs import InputPlan, input_plan
from sigcat.adapter.core.c.data.outputs import OutputPlan, output_plan
from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.schedule.schedule import is_due, runs, statement, waits
from sigcat.adapter.core.plan import Call, Error, Logical, Reaction


class CallPlan(NamedTuple):
    """A call, and what surrounds it."""

    call: Call
    place: str
    """Member with its state: `self->Step`."""
    constant: str
    statement: str
    uses_self: bool
    """Whether its statement and its hooks use the adapter."""
    runs: str
    """Whether the mode lets it run; empty if every mode does."""
    is_due: str
    waits: str
    """Whether it has to wait for other calls; empty if it never has to."""
    follows: str
    """Whether it may follow the last checkpoint; empty if it may not."""
    inputs: Sequence[InputPlan]
    outputs: Sequence[OutputPlan]
    requests: Sequence[MethodPlan]
    errors: Sequence[Error]
    """Evaluated before it."""
    late_errors: Sequence[Error]
    """Evaluated after it."""
    reactions: Sequence[Reaction]
    uses_time_before: bool
    uses_time_after: bool


def call_plan(call: Call, scope: Scope) -> CallPlan:
    """A call, as functions of the adapter surround it."""
    plan, called = scope.plan, statement(call.symbol, call.arguments, scope)
    errors, late_errors = (plan.errors_of(call.name, late=late) for late in (False, True))
    requests = [method for method in plan.requests if method.call == call.name]
    is_timed = bool(
        any(item.time_out for item in call.inputs) or any(method.time_out is not None for method in requests)
    )
    return CallPlan(
        call=call,
        place=f"self->{call.name}",
        constant=scope.call(call.name),
        statement=called,
        uses_self="self->" in called or bool(call.before or call.after),
        runs=runs(call, scope),
        is_due=is_due(call, scope),
        waits=waits(call, scope),
        follows=_follows(call.logical) if call.logical else "",
        inputs=[input_plan(call, item, scope) for item in call.inputs],
        outputs=[output_plan(call, output, scope) for output in call.outputs],
        requests=[method_plan(method, scope) for method in requests],
        errors=errors,
        late_errors=late_errors,
        reactions=[each for each in plan.reactions if call.name in each.calls],
        uses_time_before=bool(plan.has_windows or errors or plan.timed_reactions(call) or is_timed),
        uses_time_after=bool(plan.has_windows or call.deadline or late_errors or requests),
    )


def _follows(logical: Logical) -> str:
    numbers = [*logical.previous, *([0] if logical.is_initial else [])]
    conditions = [f"self->checkpoint.active == {number}U" for number in numbers]
    return "".join(conditions) if len(conditions) < 2 else " || ".join(f"({each})" for each in conditions)
