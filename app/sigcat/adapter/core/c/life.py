"""The beginning and the end of a function (section 1)."""

from sigcat.adapter.core.c import errors, inputs, methods, modes, outputs, parameters, schedule, supervision
from sigcat.adapter.core.c.lines import Lines, at_now, block, choice, function, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import needs_index
from sigcat.adapter.core.plan import GLOBALS, Call, CodeObject, Port


def life_functions(scope: Scope) -> list[Lines]:
    """Init, Start, Terminate, and what they need."""
    return [
        part
        for part in (
            _begin_cycle(scope), _clear(scope), _write_all(scope), _set_all(scope), _init(scope), _start(scope),
            _published(scope), _terminate(scope),
        )
        if part
    ]  # fmt: skip


def _begin_cycle(scope: Scope) -> Lines:
    """Counts of ignition cycles."""
    if not scope.plan.errors:
        return ()
    p = scope.prefix
    return lines(f"""
        /* A new ignition cycle: what failed in the one before counts, what was tested and did not fail starts anew. */
        static void {p}_BeginCycle({p}_Counts *counts)
        {{
            if (counts->has_failed) {{
                if (counts->ignition_cycles < UINT16_MAX) {{
                    counts->ignition_cycles++;
                }}
            }} else if (counts->is_tested) {{
                counts->ignition_cycles = 0U;
            }} else {{
                /* nothing is known of it */
            }}
            counts->has_failed = false;
            counts->is_tested = false;
        }}
    """)


def _clear(scope: Scope) -> Lines:
    plan = scope.plan
    groups = [
        "received" if has_received(scope) else "",
        *(call.name for call in plan.steps),
        "mode" if plan.mode_in else "",
        "mode_out" if plan.mode_out else "",
        "checkpoint" if has_checkpoints(scope) else "",
        "error" if plan.errors else "",
        "reaction" if plan.reactions else "",
        "method" if any(not each.is_offered for each in plan.methods) else "",
        "parameter" if plan.parameters else "",
        "out" if has_out(scope) else "",
        "publish" if sends(scope) else "",
        "code" if plan.code.objects and plan.code.signature != GLOBALS else "",
    ]
    body = [lines(f"(void)memset(&self->{name}, 0, sizeof(self->{name}));") for name in groups if name]
    flags = lines("self->now = 0U;\nself->is_ready = false;\nself->is_started = false;\nself->is_terminated = false;")
    anew = lines(
        f"self->object.~{_last(plan.code.class_name)}();\nnew (&self->object) {plan.code.class_name}();", ("Code",)
    )
    wired = [_wired(each, scope) for each in plan.code.objects]
    head = f"static void {scope.prefix}_Clear({scope.self_argument})"
    return function(head, [*body, flags, *wired, anew if scope.is_cpp else ()], "Everything but what is stored.")


def _last(class_name: str | None) -> str:
    """The name of a class without its namespaces."""
    return (class_name or "").rpartition("::")[2]


def _wired(each: CodeObject, scope: Scope) -> Lines:
    if each.member is None or scope.plan.code.signature == GLOBALS:
        return ()
    return lines(f"self->code.{scope.plan.code.objects[0].name}.{each.member} = &self->code.{each.name};", ("Code",))


def has_received(scope: Scope) -> bool:
    """Whether anything is received."""
    plan = scope.plan
    return bool(plan.ports or plan.foreign_errors or plan.mode_in)


def sends(scope: Scope) -> bool:
    """Whether anything is published."""
    return has_out(scope) or any(not each.is_offered for each in scope.plan.methods)


def has_out(scope: Scope) -> bool:
    """Whether anything is sent."""
    plan = scope.plan
    return bool(any(call.outputs for call in plan.steps) or plan.errors or plan.reactions or plan.mode_out)


def has_checkpoints(scope: Scope) -> bool:
    """Whether calls are checkpoints."""
    return any(call.logical for call in scope.plan.calls)


# -- init ---------------------------------------------------------------------------------------------------------


def _write_all(scope: Scope) -> Lines:
    """What there is for each variable before anything has come."""
    plan = scope.plan
    items = [(call, item) for call in plan.calls for item in call.inputs]
    runs_over_values = any(inputs.places(item) > 1 for _, item in items)
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
    head = f"static void {scope.prefix}_WriteInitialValues({scope.self_argument})"
    return function(head, body, "Variables of the code before anything is received.") if joined(body) else ()


def _set_all(scope: Scope) -> Lines:
    """What would be sent, and what is there before anything is received."""
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
    head = f"static void {scope.prefix}_SetInitialValues({scope.self_argument})"
    return function(head, body, "What is there before anything is received.") if joined(body) else ()


def _received_init(port: Port) -> Lines:
    _, item = port.consumers[0]
    return lines(f"self->received.{port.name}.value = {inputs.received_init(port)};", item.named.pointer)


def _init(scope: Scope) -> Lines:
    p, plan = scope.prefix, scope.plan
    parameters_written = [parameters.written(each, scope) for each in plan.parameters]
    after = joined([*parameters_written, lines(f"{p}_GiveMode(self);") if plan.mode_out else ()])
    can_fail = any(init.success is not None for init in plan.inits)
    body = [
        lines("bool is_ready = true;") if can_fail else (),
        _restored(scope),
        lines(f"{p}_Clear(self);"),
        lines(f"{p}_SetInitialValues(self);") if _set_all(scope) else (),
        *parameters_written,
        lines(f"{p}_WriteInitialValues(self);") if _write_all(scope) else (),
        *(_called(init, scope, is_first=not number) for number, init in enumerate(plan.inits)),
        _result(after, scope) if can_fail else joined([after, lines("self->is_ready = true;")]),
        lines("return self->is_ready;"),
    ]
    head = f"bool {p}_Init({scope.self_argument}, const {p}_Stored *stored, uint32_t ignition_cycle)"
    return function(head, body)


def _restored(scope: Scope) -> Lines:
    counts = [lines(f"{scope.prefix}_BeginCycle(&self->stored.{error.named.name});") for error in scope.plan.errors]
    return joined([
        choice([
            ("stored != NULL", lines("self->stored = *stored;")),
            ("", lines("(void)memset(&self->stored, 0, sizeof(self->stored));")),
        ]),
        block("if (!self->stored.has_cycle || (self->stored.ignition_cycle != ignition_cycle))",
              [*counts, lines("self->stored.ignition_cycle = ignition_cycle;\nself->stored.has_cycle = true;")]),
    ])  # fmt: skip


def _called(init: Call, scope: Scope, *, is_first: bool) -> Lines:
    """A call of init; after one that failed there is no other."""
    call = schedule.called(init, scope)
    text = f"{call};" if init.success is None else f"is_ready = ({call} == {init.success});"
    whole = joined([
        supervision.reported(init, scope),
        *(lines(f"{hook}(self);", init.pointer) for hook in init.before),
        lines(text, init.pointer),
        *(lines(f"{hook}(self);", init.pointer) for hook in init.after),
    ])  # fmt: skip
    can_fail = any(each.success is not None for each in scope.plan.inits)
    return block("if (is_ready)", [whole]) if can_fail and not is_first else whole


def _result(after: Lines, scope: Scope) -> Lines:
    """After a failed init all reactions are active."""
    reactions = [lines(f"self->out.{one.named.name} = {one.active}U;") for one in scope.plan.reactions]
    failed = joined(reactions) or lines("/* nothing runs */")
    return joined([
        choice([("is_ready", after or lines("/* it may start */")), ("", failed)]), lines("self->is_ready = is_ready;")
    ])  # fmt: skip


# -- start and end ------------------------------------------------------------------------------------------------


def _start(scope: Scope) -> Lines:
    p, plan = scope.prefix, scope.plan
    first = [
        *(lines(f"self->publish.{each.named.name} = true;") for each in plan.reactions),
        lines(f"self->publish.{plan.mode_out.named.name} = self->mode_out.is_known;") if plan.mode_out else (),
        *(_begun(call) for call in plan.steps if call.cycle is not None),
    ]
    later = [_dropped(call, scope) for call in plan.steps]
    entered = [lines(f"{p}_Enter_{call.name}(self, t);") for call in plan.steps]
    windows = [
        lines(f"self->{call.name}.alive.window = self->{call.name}.release;") for call in plan.steps if call.alive
    ]
    ways = [("!self->is_started", joined([*entered, *first, *windows])), ("", joined([*later, *entered]))]
    body = [
        supervision.closed(scope),
        choice(ways) if joined([*first, *later, *entered]) else (),
        lines("self->is_started = true;"),
    ]
    whole = block("if (self->is_ready && !self->is_terminated)", [at_now(body, p)])
    return function(f"void {p}_Start({scope.self_argument}, uint64_t t)", [whole])


def _begun(call: Call) -> Lines:
    return lines(f"self->{call.name}.release = t + UINT64_C({call.offset});")


def _dropped(call: Call, scope: Scope) -> Lines:
    """What was due before now; what is due at this very time is due."""
    part = modes.dropped(call, scope)
    if call.cycle is None:
        return part
    condition = f"if (t > self->{call.name}.release)"
    counted = part[1]._replace(text=part[1].text.replace("((t - ", "((t - UINT64_C(1) - "))
    return (part[0]._replace(text=f"{condition} {{"), counted, *part[2:])


def _published(scope: Scope) -> Lines:
    body = [lines("(void)memset(&self->publish, 0, sizeof(self->publish));") if sends(scope) else ()]
    return function(f"void {scope.prefix}_Published({scope.self_argument})", body)


def _terminate(scope: Scope) -> Lines:
    p = scope.prefix
    inner = [
        *(_ended(terminate, scope) for terminate in scope.plan.terminates),
        parameters.learned(scope),
        lines("self->is_terminated = true;\nself->is_started = false;"),
    ]
    body = [lines(f"(void){p}_Now(self, t);"), block("if (self->is_ready && !self->is_terminated)", inner)]
    return function(f"void {p}_Terminate({scope.self_argument}, uint64_t t)", body)


def _ended(terminate: Call, scope: Scope) -> Lines:
    return joined([
        supervision.reported(terminate, scope),
        *(lines(f"{hook}(self);", terminate.pointer) for hook in terminate.before),
        lines(f"{schedule.called(terminate, scope)};", terminate.pointer),
        *(lines(f"{hook}(self);", terminate.pointer) for hook in terminate.after),
    ])  # fmt: skip
