"""When calls are due (section 9), and what surrounds each of them."""

from sigcat.adapter.core.c import errors, inputs, methods, modes, outputs, parameters, supervision
from sigcat.adapter.core.c.lines import Line, Lines, block, function, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import CLASS, Call


def enter_functions(scope: Scope) -> list[Lines]:
    """Clocks that start anew."""
    return [_enter(call, scope) for call in scope.plan.steps]


def _enter(call: Call, scope: Scope) -> Lines:
    late = [lines(f"self->{call.name}.in.{item.named.name}.clock.is_late = false;")
            for item in call.inputs if item.time_out]  # fmt: skip
    body = [
        lines(f"self->{call.name}.entered = t;"),
        *late,
        lines(f"self->{call.name}.ends = 0U;") if call.alive else (),
    ]
    head = f"static void {scope.prefix}_Enter_{call.name}({scope.self_argument}, uint64_t t)"
    return function(head, body, f"{call.interface} runs from now on: its clocks start.")


# -- due ----------------------------------------------------------------------------------------------------------


def due_functions(scope: Scope) -> list[Lines]:
    """Which call is due."""
    found = [_release(call, scope) for call in scope.plan.steps]
    return [*found, *(_is_due(call, scope) for call in scope.plan.due), _next_call(scope), _next_time(scope)]


def _release(call: Call, scope: Scope) -> Lines:
    place, runs = f"self->{call.name}", modes.condition(call, scope)
    dropped = f"{place}.dropped = {scope.prefix}_Added({place}.dropped, {place}.waiting);\n{place}.waiting = 0U;"
    if call.cycle is not None:
        cycle = time(call.cycle)
        body = [block(f"if (t >= {place}.release)", [lines(f"""
            const uint64_t releases = ((t - {place}.release) / {cycle}) + 1U;
            {place}.release += releases * {cycle};
            {place}.waiting = {scope.prefix}_Added({place}.waiting, releases);
        """)])]  # fmt: skip
    else:
        body = []
    if runs != "true":
        body.append(block(f"if (!{runs})", [lines(dropped)]))
    head = f"static void {scope.prefix}_Release_{call.name}({scope.self_argument}, uint64_t t)"
    when = f"every {call.cycle / 10**6:g} ms" if call.cycle is not None else "when its signals are received"
    return function(head, body, f"{call.interface} is released {when}. The grid stays, whatever is missed.")


def _is_due(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}"
    conditions = [f"({place}.waiting > 0U)", f"!{place}.is_running"]
    if call.debounce:
        conditions.append(f"(!{place}.has_begun || ((t - {place}.begun) >= {time(call.debounce)}))")
    known = {step.name: step for step in scope.plan.steps}
    for name in call.previous:
        if name in known and name != call.name:
            excluded = modes.condition(known[name], scope)
            unless = "" if excluded == "true" else f" || !{excluded}"
            conditions.append(f"(self->{name}.has_ended{unless})")
    body = [
        lines("const bool is_due = " + "\n    && ".join(conditions) + ";"),
        block("if (is_due)", [_taken_up(call, scope)]),
        lines("return is_due;"),
    ]
    head = f"static bool {scope.prefix}_IsDue_{call.name}({scope.self_argument}, uint64_t t)"
    return function(head, body, f"Whether {call.interface} has to run now.")


def _taken_up(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}"
    if call.cycle is None:
        return lines(f"{place}.waiting--;" if call.counts_events else f"{place}.waiting = 0U;")
    overrun = f"{place}.overrun = ({place}.waiting > 1U) ? {scope.present} : {scope.absent};\n"
    return lines(
        f"{overrun if call.overrun_error else ''}"
        f"{place}.missed = {scope.prefix}_Added({place}.missed, (uint64_t){place}.waiting - 1U);\n"
        f"{place}.waiting = 0U;"
    )


def _next_call(scope: Scope) -> Lines:
    p, none = scope.prefix, scope.constant("NO_CALL")
    released = [lines(f"{p}_Release_{call.name}(self, now);") for call in scope.plan.steps]
    chain: list[Line] = []
    for number, call in enumerate(scope.plan.due):
        before = "} else if" if number else "if"
        chain += [Line(f"{before} ({p}_IsDue_{call.name}(self, now)) {{"), Line(f"    due = {scope.call(call.name)};")]
    chain += [Line("} else {"), Line("    /* none is due */"), Line("}")]
    inner = [
        lines(f"{p}_TakeMode(self, now);") if scope.plan.mode_in else (),
        *released,
        tuple(chain) if scope.plan.due else (),
    ]
    body = [
        lines(f"const uint64_t now = {p}_Now(self, t);\n{p}_Call due = {none};\n"),
        block("if (self->is_started)", inner),
        lines("return due;"),
    ]
    return function(f"{p}_Call {p}_NextCall({scope.self_argument}, uint64_t t)", body)


def _next_time(scope: Scope) -> Lines:
    body = [lines("uint64_t next = UINT64_MAX;\n"),
            block("if (self->is_started)", [_next_of(call, scope) for call in scope.plan.steps]),
            lines("return next;")]  # fmt: skip
    return function(f"uint64_t {scope.prefix}_NextTime(const {scope.prefix} *self)", body)


def _next_of(call: Call, scope: Scope) -> Lines:
    place, earlier = f"self->{call.name}", f"{scope.prefix}_Earlier"
    waits = f"{place}.begun + {time(call.debounce)}" if call.debounce else "self->now"
    if call.debounce:
        waits = f"({place}.has_begun ? ({waits}) : self->now)"
    parts = [
        lines(f"next = {earlier}(next, {place}.release);") if call.cycle is not None else (),
        block(f"if (({place}.waiting > 0U) && !{place}.is_running)", [lines(f"next = {earlier}(next, {waits});")]),
        lines(f"next = {earlier}(next, {place}.window + {time(call.alive.window)});") if call.alive else (),
        block(f"if ({place}.is_running)", [
            lines(f"next = {earlier}(next, {place}.begun + {time(call.deadline.most + 1)});")
        ]) if call.deadline else (),
    ]  # fmt: skip
    runs = modes.condition(call, scope)
    return joined(parts) if runs == "true" else block(f"if ({runs})", parts)


# -- around a call ------------------------------------------------------------------------------------------------


def call_functions(call: Call, scope: Scope) -> list[Lines]:
    """What the platform calls around each call."""
    return [_set_input(call, scope), _begin(call, scope), _run(call, scope), _get_output(call, scope)]


def _mark(point: int, call: Call, scope: Scope) -> Lines:
    return lines(f"{scope.constant('MARK')}(self, {point}, {scope.call(call.name)});")


def _set_input(call: Call, scope: Scope) -> Lines:
    p = scope.prefix
    body = [
        _mark(0, call, scope),
        lines(f"t = {p}_Now(self, t);"),
        modes.written(scope),
        *(inputs.taken(call, item, scope) for item in call.inputs if not item.is_immediate),
        *(parameters.written(each, scope) for each in scope.plan.parameters
          if call.name in each.calls and not each.learned),
        methods.taken(call, scope),
        supervision.reported(call, scope),
        errors.evaluated(scope.plan.errors_of(call.name, late=False), scope),
        _status(call, scope),
        errors.reacted(call.name, scope),
    ]  # fmt: skip
    return function(f"void {p}_SetInput_{call.name}({scope.self_argument}, uint64_t t)", body)


def _status(call: Call, scope: Scope) -> Lines:
    return joined(
        lines(f"{scope.variable(error.status_variable)} = self->out.{error.named.name};", error.named.pointer)
        for error in scope.plan.errors
        if error.status_variable and error.call == call.name
    )


def _begin(call: Call, scope: Scope) -> Lines:
    place = f"self->{call.name}"
    body = [
        lines(f"t = {scope.prefix}_Now(self, t);"),
        *(inputs.taken(call, item, scope) for item in call.inputs if item.is_immediate),
        lines(f"{place}.begun = t;\n{place}.has_begun = true;\n{place}.is_running = true;"),
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
    p, place = scope.prefix, f"self->{call.name}"
    late = scope.plan.errors_of(call.name, late=True)
    body = [
        lines(f"t = {p}_Now(self, t);"),
        *(outputs.given(call, output, scope) for output in call.outputs),
        lines(f"{p}_GiveMode(self);") if scope.plan.mode_out else (),
        *(_condition(error.named.name, scope.variable(error.variable), scope)
          for error in scope.plan.errors if error.variable and error.call == call.name),
        supervision.ended(call, scope),
        errors.evaluated(late, scope),
        methods.requested(call, scope),
        lines(f"{place}.is_running = false;\n{place}.has_ended = true;"),
        _mark(3, call, scope),
    ]  # fmt: skip
    return function(f"void {p}_GetOutput_{call.name}({scope.self_argument}, uint64_t t)", body)


def _condition(name: str, variable: str, scope: Scope) -> Lines:
    pointer = next(error.named.pointer for error in scope.plan.errors if error.named.name == name)
    return lines(f"self->error.{name}.variable = ({variable} != 0) ? {scope.present} : {scope.absent};", pointer)
