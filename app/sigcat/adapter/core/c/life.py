"""The beginning and the end of a function (section 1)."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c import errors, inputs, methods, modes, outputs, schedule, supervision
from sigcat.adapter.core.c.layout import c_functions, text_of
from sigcat.adapter.core.c.lines import TIME, Lines, joined, lines, replaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import needs_index
from sigcat.adapter.core.plan import Call, CorePlan, Port


class _Call(NamedTuple):
    """A call at the beginning or the end: its checkpoint, and its statement."""

    call: Call
    reported: str
    statement: str


class _Plan(NamedTuple):
    """Plan of the functions: members that are cleared, and statements for values before anything was received."""

    p: str
    m: str
    plan: CorePlan
    cleared: Sequence[str]
    class_name: str
    written: str
    set: str
    can_fail: bool
    inits: Sequence[_Call]
    closes: bool
    dropped: Sequence[str]
    terminates: Sequence[_Call]


def life_functions(scope: Scope) -> list[Lines]:
    """Init, Start, Terminate, and what they need."""
    plan = scope.plan
    made = _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=plan,
        cleared=_cleared(plan),
        class_name=(plan.code.class_name or "").rpartition("::")[2],
        written=text_of(_write_all(scope)),
        set=text_of(_set_all(scope)),
        can_fail=any(init.success is not None for init in plan.inits),
        inits=[_call(call, scope) for call in plan.inits],
        closes=any(call.alive for call in plan.steps),
        dropped=[text_of(_dropped(call, scope)) for call in plan.steps],
        terminates=[_call(call, scope)._replace(statement=schedule.called(call, scope)) for call in plan.terminates],
    )
    return c_functions("life.c.j2", made)


def _call(call: Call, scope: Scope) -> _Call:
    called = schedule.called(call, scope)
    statement = called if call.success is None else f"is_ready = ({called} == {call.success})"
    return _Call(call, text_of(supervision.reported(call, scope)), statement)


def _cleared(plan: CorePlan) -> list[str]:
    groups = {
        "mode": plan.mode_in,
        "mode_out": plan.mode_out,
        "checkpoint": plan.has_checkpoints,
        "error": plan.errors,
        "reaction": plan.reactions,
        "method": plan.requests,
        "parameter": plan.parameters,
        "out": plan.is_sent,
        "publish": plan.published,
        "code": plan.code.objects and not plan.has_globals,
    }
    received = ["received"] if plan.is_received else []
    return [*received, *(call.name for call in plan.steps), *(name for name, has_any in groups.items() if has_any)]


def _write_all(scope: Scope) -> Lines:
    """Write the value of each variable before anything was received."""
    plan = scope.plan
    items = [(call, item) for call in plan.calls for item in call.inputs]
    runs_over_values = any(item.places > 1 for _, item in items)
    requests = [
        lines(scope.assigned(each.request_variable, "0"), each.named.pointer)
        for each in plan.methods
        if each.request_variable and not each.is_offered
    ]
    body = [
        lines("uint32_t i;") if any(needs_index(item.value) for _, item in items) else (),
        lines("uint32_t place;") if runs_over_values else (),
        *(inputs.initial(call, item, scope) for call, item in items),
        modes.written(scope),
        *(errors.status_written(error, scope) for error in plan.errors),
        *(errors.reaction_written(reaction, scope) for reaction in plan.reactions),
        *(methods.status_written(method, scope) for method in plan.requests),
        *requests,
    ]
    return joined(body)


def _set_all(scope: Scope) -> Lines:
    """Set the values to send, and the values before anything was received."""
    plan = scope.plan
    items = [(call, output) for call in plan.steps for output in call.outputs if output.queue is None]
    status = [
        *(f"self->out.{each.named.name} = {each.passed}U;" for each in plan.errors),
        *(f"self->out.{each.named.name} = {each.initial}U;" for each in plan.reactions),
    ]
    body = [
        lines("uint32_t i;") if any(needs_index(output.value) for _, output in items) else (),
        *(outputs.initial(call, output, scope) for call, output in items),
        *(lines(text) for text in status),
        *(errors.confirmed(error) for error in plan.errors),
        *(_received_init(port) for port in plan.ports if inputs.holds_init(port)),
        lines(f"self->mode.now = {plan.mode_in.initial.number}U;") if plan.mode_in else (),
        *(lines(f"{scope.prefix}_Load_{each.named.name}(self);") for each in plan.parameters),
    ]
    return joined(body)


def _received_init(port: Port) -> Lines:
    _, item = port.consumers[0]
    return lines(f"self->received.{port.name}.value = {inputs.received_init(port)};", item.named.pointer)


def _dropped(call: Call, scope: Scope) -> Lines:
    """Drop calls that were due before now; a call that is due at this very time stays due."""
    part = replaced(TIME, "now", modes.dropped(call, scope))
    if call.cycle is None:
        return part
    condition = f"if (now > self->{call.name}.release)"
    counted = part[1]._replace(text=part[1].text.replace("((now - ", "((now - UINT64_C(1) - "))
    return (part[0]._replace(text=f"{condition} {{"), counted, *part[2:])
