"""What the core has to send, handed over to the RTE; errors to the diagnosis."""

from sigcat.adapter.autosar_classic.code.names import at_core, core_object, enter, function, leave, static
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, ModeEnd, SwcPlan, Told
from sigcat.adapter.autosar_classic.code.values import Copy, by_value
from sigcat.adapter.core.c.lines import Lines, block, joined, lines


def functions(swc: SwcPlan) -> list[Lines]:
    """One for what the core may say at any time, one for the outputs of each call, one for each request."""
    return [
        *(_request(each, swc) for each in swc.methods if not each.method.is_offered),
        *(_send(step.name, swc) for step in swc.core.steps if _outputs(step.name, swc)),
        _publish(swc),
    ]


def _outputs(call: str, swc: SwcPlan) -> list[DataEnd]:
    return [end for end in swc.sent if end.call == call]


def _send(call: str, swc: SwcPlan) -> Lines:
    head = f"static void {static(swc, f'Send_{call}')}(void)"
    return function(head, [_sent(end, swc) for end in _outputs(call, swc)], "What the call provides.")


def sends(call: str, swc: SwcPlan) -> list[Lines]:
    """Sends the outputs of a call that has ended, and notes what it asks for; in the exclusive area."""
    core = core_object(swc)
    return [
        lines(f"{static(swc, f'Send_{call}')}();") if _outputs(call, swc) else (),
        *(lines(f"const boolean asks_{each.method.named.name} = {core}.publish.{each.method.named.name} ? TRUE : FALSE;")
          for each in _used(call, swc)),
    ]  # fmt: skip


def requests(call: str, swc: SwcPlan) -> list[Lines]:
    """Requests of a call that has ended; outside of the exclusive area."""
    return [
        block(f"if (asks_{each.method.named.name} != FALSE)", [lines(f"{_request_name(each, swc)}();")])
        for each in _used(call, swc)
    ]


def _used(call: str, swc: SwcPlan) -> list[MethodEnd]:
    return [each for each in swc.methods if not each.method.is_offered and each.method.call == call]


def _publish(swc: SwcPlan) -> Lines:
    body = [
        enter(swc),
        *(_noted_status(each, core_object(swc)) for each in swc.told),
        lines("") if swc.told else (),
        *(_sent(end, swc) for end in swc.sent if not end.call),
        _switched(swc.mode_out, swc) if swc.mode_out else (),
        lines(f"{swc.core.type_name}_Published({at_core(swc)});"),
        leave(swc),
        *(_told(each) for each in swc.told),
    ]
    head = f"static void {static(swc, 'Publish')}(void)"
    return function(
        head, body, "What the core may say at any time. The diagnosis is told outside of the exclusive area."
    )


def _noted_status(told: Told, core: str) -> Lines:
    name = told.error.named.name
    return lines(
        f"const boolean tells_{name} = {core}.publish.{name} ? TRUE : FALSE;\n"
        f"const boolean has_failed_{name} = {_failed(told, core)} ? TRUE : FALSE;"
    )


def _failed(told: Told, core: str) -> str:
    return f"({core}.out.{told.error.named.name} == {told.error.failed}U)"


def _sent(end: DataEnd, swc: SwcPlan) -> Lines:
    core = core_object(swc)
    place = f"{core}.out.{end.place}"
    if end.is_queue:
        each = _given(end, f"{place}.values[k]", "Send", swc)
        sent = block(f"for (uint32 k = 0U; k < {place}.count; k++)", [each])
    else:
        sent = _given(end, place, "Write", swc)
    return block(f"if ({core}.publish.{end.place})", [sent])


def _given(end: DataEnd, source: str, api: str, swc: SwcPlan) -> Lines:
    copy = Copy(swc.core, to_core=False)
    if end.type.is_number:
        return lines(f"(void)Rte_{api}_{end.name}({copy.number(source, end.type)});")
    return joined([
        lines(f"{end.type.name} value;\n"),
        copy.of("value", source, end.type, end.wire.c),
        lines(f"(void)Rte_{api}_{end.name}({by_value(end.type, 'value')});"),
    ])  # fmt: skip


def _switched(mode: ModeEnd, swc: SwcPlan) -> Lines:
    core = core_object(swc)
    switch = lines(f"(void)Rte_Switch_{mode.name}(({mode.type}){core}.out.{mode.place});")
    return block(f"if ({core}.publish.{mode.place})", [switch])


def _told(told: Told) -> Lines:
    name = told.error.named.name
    status = f"(has_failed_{name} != FALSE) ? DEM_EVENT_STATUS_FAILED : DEM_EVENT_STATUS_PASSED"
    return block(f"if (tells_{name} != FALSE)", [lines(f"(void)Rte_Call_{told.port}_{told.operation}({status});")])


# -- methods that the function uses -------------------------------------------------------------------------------


def _request_name(end: MethodEnd, swc: SwcPlan) -> str:
    return static(swc, f"Request_{end.method.named.name}")


def _request(end: MethodEnd, swc: SwcPlan) -> Lines:
    """A request that nobody takes is answered at once: it has failed."""
    name, core = end.method.named.name, core_object(swc)
    place = f"{core}.method.{name}"
    copy = Copy(swc.core, to_core=False)
    parts: list[Lines] = [lines(f"{each.type.name} given_{each.name};") for each in end.arguments]
    fills = [
        copy.of(f"given_{each.name}", f"{place}.arguments.{each.place}", each.type, each.wire.c)
        for each in end.arguments
    ]
    given = ", ".join(by_value(each.type, f"given_{each.name}") for each in end.arguments)
    results = ", &none" if end.results else ""
    none = (
        [lines(f"{swc.core.type_name}_{name}_Results none;\n\n(void)memset(&none, 0, sizeof(none));")]
        if end.results else []
    )  # fmt: skip
    failed = block(f"if (Rte_Call_{end.name}({given}) != RTE_E_OK)", [
        *none,
        enter(swc),
        lines(f"{swc.core.type_name}_Answer_{name}({at_core(swc)}, {place}.number, false{results}, {static(swc, 'Now')}());"),
        leave(swc),
    ])  # fmt: skip
    locked = [enter(swc), *fills, leave(swc)] if fills else []
    body = [*parts, lines("") if parts else (), *locked, failed]
    return function(f"static void {_request_name(end, swc)}(void)", body, end.method.named.comment)
