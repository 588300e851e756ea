"""Alive, deadline and logical supervision (section 10)."""

from sigcat.adapter.core.c import errors, modes
from sigcat.adapter.core.c.lines import Lines, at_now, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Alive, Call, Error, Logical


def window_functions(scope: Scope) -> list[Lines]:
    """Windows in which the ends of a call are counted."""
    alive = [call for call in scope.plan.steps if call.alive]
    each = [part for call in alive if call.alive for part in (_close(call, call.alive, scope), _judge(call, scope))]
    return [*each, _close_all(alive, scope)] if alive else []


def _close(call: Call, alive: Alive, scope: Scope) -> Lines:
    place, length = f"self->{call.name}.alive", time(alive.window)
    ends = f"{place}.ends"
    bad = [f"({ends} > {alive.most}U)"]
    if alive.least > 0:
        bad += [f"({ends} < {alive.least}U)", "(windows > 1U)"]
    body = [
        block(f"if (t >= ({place}.window + {length}))", [lines(f"""
            const uint64_t windows = (t - {place}.window) / {length};

            {place}.is_bad = {place}.is_bad || {' || '.join(bad)};
            {place}.has_closed = true;
            {place}.window += windows * {length};
            {place}.ends = 0U;
        """)]),
    ]  # fmt: skip
    head = f"static void {scope.prefix}_CloseWindows_{call.name}({scope.self_argument}, uint64_t t)"
    text = f"{call.interface} ends {alive.least} to {alive.most} times in each {alive.window / 10**6:g} ms."
    return function(head, body, text)


def _judge(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}.alive"
    body = block(f"if ({place}.has_closed)", [lines(f"""
        {place}.verdict = {place}.is_bad ? {scope.present} : {scope.absent};
        {place}.has_closed = false;
        {place}.is_bad = false;
    """)])  # fmt: skip
    head = f"static void {scope.prefix}_JudgeWindows_{call.name}({scope.self_argument})"
    return function(head, [body], "Windows that have closed since this was asked last.")


def _close_all(alive: list[Call], scope: Scope) -> Lines:
    found = []
    for call in alive:
        close = lines(f"{scope.prefix}_CloseWindows_{call.name}(self, t);")
        runs = modes.condition(call, scope)
        found.append(close if runs == "true" else block(f"if ({runs})", [close]))
    head = f"static void {scope.prefix}_CloseWindows({scope.self_argument}, uint64_t t)"
    return function(head, found, "Windows that are over, of calls that the mode does not exclude.")


def closed(scope: Scope) -> Lines:
    """Windows that are over by now."""
    return lines(f"{scope.prefix}_CloseWindows(self, t);") if any(call.alive for call in scope.plan.steps) else ()


# -- checkpoints --------------------------------------------------------------------------------------------------


def reported(call: Call, scope: Scope) -> Lines:
    """The checkpoint of a call."""
    return lines(f"{scope.prefix}_Report_{call.name}(self);") if call.logical else ()


def checkpoint_functions(scope: Scope) -> list[Lines]:
    """A function for each call that is in the graph."""
    return [_report(call, call.logical, scope) for call in scope.plan.calls if call.logical]


def _report(call: Call, logical: Logical, scope: Scope) -> Lines:
    active = "self->checkpoint.active"
    follows = [*logical.previous, *([0] if logical.is_initial else [])]
    conditions = [f"{active} == {number}U" for number in follows]
    absent = [
        lines(f"self->checkpoint.{each.name} = {scope.absent};")
        for each in scope.plan.calls
        if each.logical and each.logical.error
    ]
    right = joined([lines(f"{active} = {0 if logical.is_final else logical.number}U;"), *absent])
    wrong = lines(f"self->checkpoint.{call.name} = {scope.present};" if logical.error else "/* no error is told */")
    any_of = conditions[0] if len(conditions) == 1 else " || ".join(f"({each})" for each in conditions)
    body = choice([(any_of, right), ("", wrong)]) if conditions else wrong
    head = f"static void {scope.prefix}_Report_{call.name}({scope.self_argument})"
    return function(head, [body], f"The checkpoint of {call.interface}.")


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


def supervise_function(scope: Scope) -> Lines:
    """The function that finds calls that hang or never come."""
    supervised = [error for error in scope.plan.errors if error.is_supervised and error.call]
    is_measured = any(call.alive or call.deadline for call in scope.plan.steps)
    body = [
        lines(f"{scope.constant('MARK')}(self, 4, {scope.constant('NO_CALL')});") if is_measured else (),
        closed(scope),
        *(_hangs(call, scope) for call in scope.plan.steps if call.deadline),
        *(_evaluated(error, scope) for error in supervised),
    ]
    return function(f"void {scope.prefix}_Supervise({scope.self_argument}, uint64_t t)",
                    [block("if (self->is_started)", [at_now(body, scope.prefix)])])  # fmt: skip


def _hangs(call: Call, scope: Scope) -> Lines:
    assert call.deadline is not None
    place = f"self->{call.name}"
    late = f"{place}.is_running && ((t - {place}.begun) > {time(call.deadline.most)})"
    return block(f"if ({late})", [lines(f"{place}.deadline = {scope.present};")])


def _evaluated(error: Error, scope: Scope) -> Lines:
    """An error whose call runs in this mode."""
    call = next(step for step in scope.plan.steps if step.name == error.call)
    runs = modes.condition(call, scope)
    part = errors.evaluated((error,), scope)
    return part if runs == "true" else block(f"if ({runs})", [part])
