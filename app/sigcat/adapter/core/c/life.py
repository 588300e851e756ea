"""The beginning and the end of a function (section 1)."""

from sigcat.adapter.core.c import inputs, outputs, parameters, schedule, supervision
from sigcat.adapter.core.c.lines import Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import needs_index
from sigcat.adapter.core.plan import CodeObject, Port


def life_functions(scope: Scope) -> list[Lines]:
    """Init, Start, Terminate, and what they need."""
    return [
        part
        for part in (
            _begin_cycle(scope), _clear(scope), _initial_inputs(scope), _initial_outputs(scope), _init(scope),
            _start(scope), _published(scope), _terminate(scope),
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
    groups = [
        "received" if has_received(scope) else "",
        *(call.name for call in scope.plan.steps),
        "mode" if scope.plan.mode_in else "",
        "checkpoint" if has_checkpoints(scope) else "",
        "error" if scope.plan.errors else "",
        "reaction" if any(each.time_out is not None for each in scope.plan.reactions) else "",
        "method" if any(not each.is_offered for each in scope.plan.methods) else "",
        "parameter" if any(each.range_error for each in scope.plan.parameters) else "",
        "out" if has_out(scope) else "",
        "publish" if has_out(scope) or any(not each.is_offered for each in scope.plan.methods) else "",
        "code" if scope.plan.code.objects and scope.plan.code.signature != "Globals" else "",
    ]
    body = [lines(f"(void)memset(&self->{name}, 0, sizeof(self->{name}));") for name in groups if name]
    flags = lines("self->now = 0U;\nself->started = 0U;\nself->is_ready = false;\nself->is_started = false;")
    head = f"static void {scope.prefix}_Clear({scope.self_argument})"
    return function(head, [*body, flags, *(_wired(each, scope) for each in scope.plan.code.objects)],
                    "Everything but what is stored.")  # fmt: skip


def _wired(each: CodeObject, scope: Scope) -> Lines:
    if each.member is None or scope.plan.code.signature == "Globals":
        return ()
    return lines(f"self->code.{scope.plan.code.objects[0].name}.{each.member} = &self->code.{each.name};", ("Code",))


def has_received(scope: Scope) -> bool:
    """Whether anything is received."""
    plan = scope.plan
    return bool(plan.ports or plan.foreign_errors or plan.reactions or plan.mode_in)


def has_out(scope: Scope) -> bool:
    """Whether anything is sent."""
    plan = scope.plan
    return bool(any(call.outputs for call in plan.steps) or plan.errors or plan.reactions or plan.mode_out)


def has_checkpoints(scope: Scope) -> bool:
    """Whether calls are checkpoints."""
    plan = scope.plan
    return any(call is not None and call.logical for call in (plan.init, *plan.steps, plan.terminate))


# -- init ---------------------------------------------------------------------------------------------------------


def _initial_inputs(scope: Scope) -> Lines:
    items = [(call, item) for call in scope.plan.steps for item in call.inputs]
    if not items:
        return ()
    runs_over_values = any(item.queue and item.queue.values_per_step > 1 for _, item in items)
    body = [
        lines("uint32_t i;") if any(needs_index(item.value) for _, item in items) else (),
        lines("uint32_t taken;") if runs_over_values else (),
        *(inputs.initial(call, item, scope) for call, item in items),
    ]
    head = f"static void {scope.prefix}_WriteInitialInputs({scope.self_argument})"
    return function(head, body, "Inputs before anything is received.")


def _initial_outputs(scope: Scope) -> Lines:
    plan = scope.plan
    items = [(call, output) for call in plan.steps for output in call.outputs]
    status = [
        *(f"self->out.{each.named.name} = {each.passed}U;" for each in plan.errors),
        *(f"self->out.{each.named.name} = {each.initial}U;" for each in plan.reactions),
    ]
    if plan.mode_out:
        status.append(f"self->out.{plan.mode_out.named.name} = {plan.mode_out.modes[0].number}U;")
    body = [
        lines("uint32_t i;") if any(needs_index(output.value) for _, output in items) else (),
        *(outputs.initial(call, output, scope) for call, output in items),
        *(lines(text) for text in status),
        *(_received_init(port, scope) for port in plan.ports if inputs.holds_init(port)),
        lines(f"self->mode.now = {plan.mode_in.initial.number}U;") if plan.mode_in else (),
    ]
    if not joined(body):
        return ()
    head = f"static void {scope.prefix}_SetInitialValues({scope.self_argument})"
    return function(head, body, "What would be sent, and what is there before anything is received.")


def _received_init(port: Port, scope: Scope) -> Lines:
    _, item = port.consumers[0]
    value = inputs.initial(scope.plan.steps[0], item, scope)[0].text.partition(" = ")[2]
    return lines(f"self->received.{port.name}.value = {value}", item.named.pointer)


def _init(scope: Scope) -> Lines:
    p, plan = scope.prefix, scope.plan
    always = [parameters.written(each, scope) for each in plan.parameters]
    body = [
        lines("bool is_ready = true;\n"),
        _restored(scope),
        lines(f"{p}_Clear(self);"),
        lines(f"{p}_SetInitialValues(self);") if _initial_outputs(scope) else (),
        lines(f"{p}_LoadParameters(self);") if plan.parameters else (),
        lines(f"{p}_WriteInitialInputs(self);") if _initial_inputs(scope) else (),
        *always,
        supervision.reported(plan.init, scope) if plan.init else (),
        _called(scope),
        *always,
        lines("self->is_ready = is_ready;\nself->is_terminated = false;"),
        _failed(scope),
        lines("return is_ready;"),
    ]

    head = f"bool {p}_Init({scope.self_argument}, const {p}_Stored *stored, uint32_t ignition_cycle)"
    return function(head, body)


def _restored(scope: Scope) -> Lines:
    counts = [
        lines(f"{scope.prefix}_BeginCycle(&self->stored.{error.named.name});") for error in scope.plan.errors
    ]  # fmt: skip
    begin = joined([*counts, lines("self->stored.ignition_cycle = ignition_cycle;\nself->stored.has_cycle = true;")])
    return joined([
        choice([
            ("stored != NULL", lines("self->stored = *stored;")),
            ("!self->is_known", lines("(void)memset(&self->stored, 0, sizeof(self->stored));")),
            ("", lines("/* a restart: counts go on */")),
        ]),
        lines("self->is_known = true;"),
        block("if (!self->stored.has_cycle || (self->stored.ignition_cycle != ignition_cycle))", [begin]),
    ])  # fmt: skip


def _called(scope: Scope) -> Lines:
    init = scope.plan.init
    if init is None:
        return ()
    call = schedule.called(init, scope)
    hooks = [[lines(f"{hook}(self);", init.pointer) for hook in each] for each in (init.before, init.after)]
    text = f"{call};" if init.success is None else f"is_ready = ({call} == {init.success});"
    return joined([*hooks[0], lines(text, init.pointer), *hooks[1]])


def _failed(scope: Scope) -> Lines:
    """After a failed init all reactions are active, and that is sent."""
    init = scope.plan.init
    if init is None or init.success is None or not scope.plan.reactions:
        return ()
    each = [
        lines(f"self->out.{one.named.name} = {one.active}U;\nself->publish.{one.named.name} = true;")
        for one in scope.plan.reactions
    ]
    return block("if (!is_ready)", each)


# -- start and end ------------------------------------------------------------------------------------------------


def _start(scope: Scope) -> Lines:
    p, plan = scope.prefix, scope.plan
    first = [
        lines(f"{p}_GiveMode(self);") if plan.mode_out else (),
        *(lines(f"self->publish.{each.named.name} = true;") for each in plan.reactions),
        lines(f"self->publish.{plan.mode_out.named.name} = true;") if plan.mode_out else (),
    ]
    calls = [part for call in plan.steps for part in (
        lines(f"{p}_Enter_{call.name}(self, t);"),
        lines(f"self->{call.name}.release = t + UINT64_C({call.offset});") if call.cycle is not None else (),
        lines(f"self->{call.name}.window = self->{call.name}.release;") if call.alive else (),
        lines(f"self->{call.name}.waiting = 0U;\nself->{call.name}.has_ended = false;"),
        lines(f"self->{call.name}.has_begun = false;") if call.debounce else (),
    )]  # fmt: skip
    late = [lines(f"self->reaction.{each.named.name}.is_late = false;") for each in plan.reactions
            if each.time_out is not None]  # fmt: skip
    body = [
        lines(f"t = {p}_Now(self, t);"),
        block("if (self->is_ready && !self->is_terminated)", [
            block("if (!self->is_started)", first) if joined(first) else (),
            lines("self->is_started = true;\nself->started = t;"), *late, *calls,
        ]),
    ]  # fmt: skip
    return function(f"void {p}_Start({scope.self_argument}, uint64_t t)", body)


def _published(scope: Scope) -> Lines:
    sends = has_out(scope) or any(not each.is_offered for each in scope.plan.methods)
    body = [lines("(void)memset(&self->publish, 0, sizeof(self->publish));" if sends else "(void)self;")]
    return function(f"void {scope.prefix}_Published({scope.self_argument})", body)


def _terminate(scope: Scope) -> Lines:
    p, terminate = scope.prefix, scope.plan.terminate
    inner = [
        supervision.reported(terminate, scope) if terminate else (),
        *([lines(f"{hook}(self);", terminate.pointer) for hook in terminate.before] if terminate else []),
        lines(f"{schedule.called(terminate, scope)};", terminate.pointer) if terminate else (),
        *([lines(f"{hook}(self);", terminate.pointer) for hook in terminate.after] if terminate else []),
        parameters.learned(scope),
        lines("self->is_terminated = true;\nself->is_started = false;"),
    ]
    body = [
        lines(f"(void){p}_Now(self, t);"),
        block("if (self->is_ready && !self->is_terminated)", inner),
    ]
    return function(f"void {p}_Terminate({scope.self_argument}, uint64_t t)", body)
