"""Alive, deadline and logical supervision (section 10)."""

from sigcat.adapter.core.c import errors, modes
from sigcat.adapter.core.c.lines import Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Alive, Call, Error, Logical


def window_functions(scope: Scope) -> list[Lines]:
    """Windows in which the ends of a call are counted."""
    return [_close(call, call.alive, scope) for call in scope.plan.steps if call.alive]


def _close(call: Call, alive: Alive, scope: Scope) -> Lines:
    place, length = f"self->{call.name}", time(alive.window)
    is_good = _is_good(f"{place}.ends", alive)
    empty_is_bad = alive.least > 0
    later = f"windows = (t - {place}.window) / {length};"
    bad = f"!({is_good})" + (" || (windows > 1U)" if empty_is_bad else "")
    body = [
        lines("uint64_t windows = 0U;\n"),
        block(f"if (t >= {place}.window)", [lines(later)]),
        block("if (windows > 0U)", [lines(f"""
            {place}.alive = ({bad}) ? {scope.present} : {scope.absent};
            {place}.window += windows * {length};
            {place}.ends = 0U;
        """)]),
    ]  # fmt: skip
    head = f"static void {scope.prefix}_CloseWindows_{call.name}({scope.self_argument}, uint64_t t)"
    each = "each" if alive.least != alive.most else ""
    text = f"{call.interface} ends {alive.least} to {alive.most} times in {each or 'each'} {alive.window / 10**6:g} ms."
    return function(head, body, text)


def _is_good(ends: str, alive: Alive) -> str:
    least = f"({ends} >= {alive.least}U)" if alive.least > 0 else ""
    return " && ".join(filter(None, (least, f"({ends} <= {alive.most}U)")))


def reported(call: Call, scope: Scope) -> Lines:
    """The checkpoint of a call."""
    return lines(f"{scope.prefix}_Report_{call.name}(self);") if call.logical else ()


def checkpoint_functions(scope: Scope) -> list[Lines]:
    """A function for each call that is in the graph."""
    plan = scope.plan
    calls = [call for call in (plan.init, *plan.steps, plan.terminate) if call and call.logical]
    return [_report(call, call.logical, scope) for call in calls if call.logical]


def _report(call: Call, logical: Logical, scope: Scope) -> Lines:
    active = "self->checkpoint.active"
    conditions = [f"({active} == {number}U)" for number in logical.previous]
    conditions += [f"({active} == 0U)"] if logical.is_initial else []
    judged = [lines(f"self->checkpoint.{call.name} = {{}};".replace("{}", verdict)) if logical.error else ()
              for verdict in (scope.absent, scope.present)]  # fmt: skip
    right = joined([lines(f"{active} = {'0U' if logical.is_final else f'{logical.number}U'};"), judged[0]])
    ways = [(" || ".join(conditions), right)] if conditions else []
    wrong = judged[1] or lines("/* nobody wants to know */")
    body = choice([*ways, ("", wrong)]) if ways else wrong
    head = f"static void {scope.prefix}_Report_{call.name}({scope.self_argument})"
    return function(head, [body], f"The checkpoint of {call.interface}.")


def ended(call: Call, scope: Scope) -> Lines:
    """The end of a call: in its window, and within its deadline."""
    place = f"self->{call.name}"
    found: list[Lines] = []
    if call.alive:
        found.append(lines(f"{scope.prefix}_CloseWindows_{call.name}(self, t);\n{place}.ends++;"))
    if call.deadline:
        took = f"(t - {place}.begun)"
        late = f"({took} > {time(call.deadline.most)})"
        early = f"({took} < {time(call.deadline.least)}) || " if call.deadline.least else ""
        found.append(lines(f"{place}.deadline = ({early}{late}) ? {scope.present} : {scope.absent};"))
    return joined(found)


def supervise_function(scope: Scope) -> Lines:
    """What the platform calls now and then: for a call that hangs or never comes."""
    supervised = tuple(error for error in scope.plan.errors if error.is_supervised)
    body = [
        *(_watched(call, scope) for call in scope.plan.steps if call.alive or call.deadline),
        *(_evaluated(error, scope) for error in supervised),
    ]
    whole = [lines(f"t = {scope.prefix}_Now(self, t);"), block("if (self->is_started)", body) if joined(body) else ()]
    return function(f"void {scope.prefix}_Supervise({scope.self_argument}, uint64_t t)", whole)


def _evaluated(error: Error, scope: Scope) -> Lines:
    """An error whose call runs in this mode."""
    call = next((step for step in scope.plan.steps if step.name == error.call), None)
    runs = modes.condition(call, scope) if call else "true"
    part = errors.evaluated((error,), scope)
    return part if runs == "true" else block(f"if ({runs})", [part])


def _watched(call: Call, scope: Scope) -> Lines:
    place, runs = f"self->{call.name}", modes.condition(call, scope)
    windows = lines(f"{scope.prefix}_CloseWindows_{call.name}(self, t);") if call.alive else ()
    found = [windows if runs == "true" or not windows else block(f"if ({runs})", [windows])]
    if call.deadline:
        late = f"{place}.is_running && ((t - {place}.begun) > {time(call.deadline.most)})"
        found.append(block(f"if ({late})", [lines(f"{place}.deadline = {scope.present};")]))
    return joined(found)
