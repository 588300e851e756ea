"""When calls are due (section 9), and what surrounds each of them."""

from sigcat.adapter.core.c import errors, inputs, methods, modes, outputs, parameters, supervision
from sigcat.adapter.core.c.lines import Line, Lines, at_now, block, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import CLASS, Call


def enter_functions(scope: Scope) -> list[Lines]:
    """Clocks and windows that start anew."""
    return [_enter(call, scope) for call in scope.plan.steps]


def _enter(call: Call, scope: Scope) -> Lines:
    alive = lines(f"""
        self->{call.name}.alive.verdict = {scope.constant("NOT_JUDGED")};
        self->{call.name}.alive.has_closed = false;
        self->{call.name}.alive.is_bad = false;
        self->{call.name}.alive.window = t;
        self->{call.name}.alive.ends = 0U;
    """)
    body = [lines(f"self->{call.name}.entered = t;"), alive if call.alive else ()]
    head = f"static void {scope.prefix}_Enter_{call.name}({scope.self_argument}, uint64_t t)"
    return function(head, body, f"{call.interface} runs from now on: its clocks and windows begin.")


# -- due ----------------------------------------------------------------------------------------------------------


def due_functions(scope: Scope) -> list[Lines]:
    """Which call is due."""
    waits = [_waits(call, scope) for call in scope.plan.steps if _may_wait(call, scope)]
    return [*waits, *(_is_due(call, scope) for call in scope.plan.due), _next_call(scope), _next_time(scope)]


def _previous(call: Call, scope: Scope) -> list[Call]:
    return [step for step in scope.plan.steps if step.name in call.previous and step.name != call.name]


def _excluding(call: Call, scope: Scope) -> list[Call]:
    """Calls that do not run at the same time as this one."""
    others = (step for step in scope.plan.steps if step.name != call.name)
    return [step for step in others if call.is_exclusive or step.is_exclusive]


def _may_wait(call: Call, scope: Scope) -> bool:
    return bool(_previous(call, scope) or _excluding(call, scope))


def _waits(call: Call, scope: Scope) -> Lines:
    conditions = [f"self->{other.name}.is_active" for other in _excluding(call, scope)]
    for other in _previous(call, scope):
        runs = modes.condition(other, scope)
        ended = f"!self->{other.name}.has_ended"
        conditions.append(ended if runs == "true" else f"({ended} && {runs})")
    head = f"static bool {scope.prefix}_Waits_{call.name}(const {scope.prefix} *self)"
    text = f"return {' || '.join(conditions)};"
    return function(head, [lines(text)], f"Whether {call.interface} has to wait for another one.")


def _conditions(call: Call, scope: Scope) -> list[str]:
    place = f"self->{call.name}"
    runs = modes.condition(call, scope)
    when = f"(t >= {place}.release)" if call.cycle is not None else f"({place}.events > 0U)"
    rested = f"(!{place}.has_begun || ((t - {place}.begun) >= {time(call.debounce)}))" if call.debounce else ""
    waits = f"!{scope.prefix}_Waits_{call.name}(self)" if _may_wait(call, scope) else ""
    return [each for each in ("" if runs == "true" else runs, when, f"!{place}.is_active", rested, waits) if each]


def _is_due(call: Call, scope: Scope) -> Lines:
    body = [
        lines(f"const bool is_due = {' && '.join(_conditions(call, scope))};"),
        block("if (is_due)", [_answered(call, scope)]),
        lines("return is_due;"),
    ]
    head = f"static bool {scope.prefix}_IsDue_{call.name}({scope.self_argument}, uint64_t t)"
    when = f"every {call.cycle / 10**6:g} ms" if call.cycle is not None else "when its signals are received"
    return function(head, body, f"Whether {call.interface} has to run now: {when}. The grid stays, whatever is missed.")


def _answered(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}"
    if call.cycle is None:
        none = lines(f"{place}.overrun = {scope.absent};") if call.overrun_error else ()
        return joined([_fewer_events(call, place), lines(f"{place}.is_active = true;"), none])
    cycle = time(call.cycle)
    overrun = f"{place}.overrun = (releases > 1U) ? {scope.present} : {scope.absent};\n"
    return joined([
        lines(f"const uint64_t releases = ((t - {place}.release) / {cycle}) + 1U;"),
        (Line(""),),
        lines(f"{place}.release += releases * {cycle};"),
        lines(f"{place}.missed = {scope.prefix}_Added({place}.missed, releases - 1U);"),
        lines(f"{overrun if call.overrun_error else ''}{place}.is_active = true;"),
    ])  # fmt: skip


def _fewer_events(call: Call, place: str) -> Lines:
    if call.events_per_call == 1:
        return lines(f"{place}.events--;")
    most = f"{call.events_per_call}U"
    return lines(f"{place}.events -= ({place}.events < {most}) ? {place}.events : {most};")


def _next_call(scope: Scope) -> Lines:
    p, none = scope.prefix, scope.constant("NO_CALL")
    chain: list[Line] = []
    for number, call in enumerate(scope.plan.due):
        before = "} else if" if number else "if"
        chain += [Line(f"{before} ({p}_IsDue_{call.name}(self, t)) {{"), Line(f"    due = {scope.call(call.name)};")]
    chain += [Line("} else {"), Line("    /* none is due */"), Line("}")]
    inner = [
        supervision.closed(scope),
        lines(f"{p}_TakeMode(self, t);") if scope.plan.mode_in else (),
        tuple(chain) if scope.plan.due else (),
    ]
    body = [lines(f"{p}_Call due = {none};"), block("if (self->is_started)", [at_now(inner, p)]), lines("return due;")]
    return function(f"{p}_Call {p}_NextCall({scope.self_argument}, uint64_t t)", body)


def _next_time(scope: Scope) -> Lines:
    body = [lines("uint64_t next = UINT64_MAX;"),
            block("if (self->is_started)", [_next_of(call, scope) for call in scope.plan.steps]),
            lines("return next;")]  # fmt: skip
    return function(f"uint64_t {scope.prefix}_NextTime(const {scope.prefix} *self)", body)


def _next_of(call: Call, scope: Scope) -> Lines:
    """The release of a call, or the end of its pause, or that of its window."""
    place, p = f"self->{call.name}", scope.prefix
    runs = modes.condition(call, scope)
    release = f"{place}.release" if call.cycle is not None else "0U"
    rested = f"{p}_Later({release}, {place}.has_begun ? ({place}.begun + {time(call.debounce)}) : 0U)"
    due = lines(f"next = {p}_Earlier(next, {rested if call.debounce else release});")
    ready = [f"!{place}.is_active"] + ([] if call.cycle is not None else [f"({place}.events > 0U)"])
    waiting = [f"!{p}_Waits_{call.name}(self)"] if _may_wait(call, scope) else []
    window = lines(f"next = {p}_Earlier(next, {place}.alive.window + {time(call.alive.window)});") if call.alive else ()
    ready_block = block(f"if ({' && '.join([*ready, *waiting])})", [due])
    if runs == "true":
        return joined([ready_block, window])
    excluded = block(f"if ({' && '.join(ready)})", [lines(f"next = {p}_Earlier(next, {release});")])
    if ready_block == excluded:
        return joined([ready_block, block(f"if ({runs})", [window]) if window else ()])
    first = joined([ready_block, window])
    return (Line(f"if ({runs}) {{"), *_in(first), Line("} else {"), *_in(excluded), Line("}"))


def _in(part: Lines) -> Lines:
    return tuple(line._replace(text=f"    {line.text}") for line in part)


# -- around a call ------------------------------------------------------------------------------------------------


def call_functions(call: Call, scope: Scope) -> list[Lines]:
    """What the platform calls around each call."""
    return [_set_input(call, scope), _begin(call, scope), _run(call, scope), _get_output(call, scope)]


def _mark(point: int, call: Call, scope: Scope) -> Lines:
    return lines(f"{scope.constant('MARK')}(self, {point}, {scope.call(call.name)});")


def _set_input(call: Call, scope: Scope) -> Lines:
    p, plan = scope.prefix, scope.plan
    index = lines("uint32_t i;") if methods.takes_arrays(call, scope) else ()
    body = [
        _mark(0, call, scope),
        supervision.closed(scope),
        supervision.reported(call, scope),
        modes.written(scope),
        *(inputs.judged(call, item, scope) for item in call.inputs),
        *(inputs.taken(call, item, scope) for item in call.inputs if not item.is_immediate),
        *(parameters.written(each, scope) for each in plan.parameters if call.name in each.calls and not each.learned),
        errors.evaluated(plan.errors_of(call.name, late=False), scope),
        *(errors.status_written(error, scope) for error in plan.errors if call.name in error.calls),
        errors.reacted(call.name, scope),
        methods.taken(call, scope),
    ]
    head = f"void {p}_SetInput_{call.name}({scope.self_argument}, uint64_t t)"
    return function(head, [index, at_now(body, p)])


def _begin(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}"
    body = [
        *(inputs.taken(call, item, scope) for item in call.inputs if item.is_immediate),
        lines(f"{place}.begun = {scope.prefix}_Now(self, t);"),
        lines(f"{place}.has_begun = true;") if call.debounce else (),
        lines(f"{place}.is_running = true;") if call.deadline else (),
    ]
    return function(f"void {scope.prefix}_Begin_{call.name}({scope.self_argument}, uint64_t t)", body)


def called(call: Call, scope: Scope) -> str:
    """The call itself."""
    arguments = ", ".join(f"&self->code.{name}" for name in call.arguments)
    at = "self->object." if scope.plan.code.signature == CLASS else ""
    return f"{at}{call.symbol}({arguments})"


def _run(call: Call, scope: Scope) -> Lines:
    body = [
        *(lines(f"{hook}(self);", call.pointer) for hook in call.before),
        _mark(1, call, scope),
        lines(f"{called(call, scope)};", call.pointer),
        _mark(2, call, scope),
        *(lines(f"{hook}(self);", call.pointer) for hook in call.after),
    ]
    return function(f"void {scope.prefix}_Run_{call.name}({scope.self_argument})", body, call.description)


def _get_output(call: Call, scope: Scope) -> Lines:
    p, place, plan = scope.prefix, f"self->{call.name}", scope.plan
    index = lines("uint32_t i;") if methods.requests_arrays(call, scope) else ()
    body = [
        supervision.closed(scope),
        supervision.ended(call, scope),
        *(outputs.given(call, output, scope) for output in call.outputs),
        outputs.published(call),
        *(_condition(error.named.name, scope.is_set(error.variable), scope)
          for error in plan.errors if error.variable and error.call == call.name),
        errors.evaluated(plan.errors_of(call.name, late=True), scope),
        methods.requested(call, scope),
        lines(f"{p}_GiveMode(self);") if plan.mode_out else (),
        lines(f"{place}.is_active = false;"),
        lines(f"{place}.is_running = false;") if call.deadline else (),
        lines(f"{place}.has_ended = true;") if any(call.name in other.previous for other in plan.steps) else (),
        _mark(3, call, scope),
    ]  # fmt: skip
    return function(f"void {p}_GetOutput_{call.name}({scope.self_argument}, uint64_t t)", [index, at_now(body, p)])


def _condition(name: str, is_set: str, scope: Scope) -> Lines:
    pointer = next(error.named.pointer for error in scope.plan.errors if error.named.name == name)
    return lines(f"self->error.{name}.variable = {is_set} ? {scope.present} : {scope.absent};", pointer)
